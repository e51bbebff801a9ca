"""Timing queries in bulk through the pipes of `tps serve`: order, sameness, rate.

1. Every reply carries the seq of its request, in order, and none is missing.
2. A reply does not depend on what stands around it: a sample, asked alone, gets the same bytes.

Without --few also prints how many queries a second were answered, through pipes to and from this process and by the
processor time of `tps serve` alone, the latter beside a yardstick: the processor time of json.loads on the same lines.
"""

import argparse
import json
import random
import resource
import subprocess
import time


def requests(count):
    generator = random.Random(1)

    def vector(size):
        return [generator.uniform(-size, size).hex() for _ in range(3)]

    for seq in range(count):
        query = {"u_A": vector(5), "u_B": vector(5), "v_A": vector(1), "v_B": vector(1), "L": 1}
        request = {"seq": seq, "op": generator.choice(["block_time", "tether_time"]), "in": query}
        yield json.dumps(request, separators=(",", ":"))


def ask(program, text):
    result = subprocess.run([program, "serve"], input=text.encode(), capture_output=True, timeout=600, check=True)
    return result.stdout.decode().splitlines()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tps")
    parser.add_argument("--few", action="store_true", help="check only")
    arguments = parser.parse_args()
    lines = list(requests(5000 if arguments.few else 200000))

    start = time.perf_counter()
    replies = ask(arguments.tps, "\n".join(lines) + "\n")
    seconds = time.perf_counter() - start
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = usage.ru_utime + usage.ru_stime

    assert [json.loads(reply)["seq"] for reply in replies] == list(range(len(lines)))
    verdicts = {json.loads(reply)["out"]["verdict"] for reply in replies}
    assert verdicts == {"receding", "miss", "hit", "overlap", "overstretched", "turning"}, verdicts
    for seq in range(0, len(lines), len(lines) // 20):
        assert ask(arguments.tps, lines[seq]) == [replies[seq]], replies[seq]

    if not arguments.few:
        start = time.process_time()
        for line in lines:
            json.loads(line)
        yardstick = time.process_time() - start
        print(f"{len(lines) / seconds:.0f} queries a second through the pipes; {len(lines) / processor:.0f} a second of "
              f"processor time, {processor / yardstick:.2f} times what json.loads takes on the same lines")


if __name__ == "__main__":
    main()
