"""An implementation that does whatever a program can do wrong. Argument: a key of MODES."""
import json
import os
import signal
import sys
import time

out = sys.stdout.buffer


def send(text):
    out.write(text)
    out.flush()


def right(line):
    question = json.loads(line)
    dimension = len(question["in"].get("u_A", [0, 0]))
    return json.dumps({"seq": question["seq"], "out": {"dp": ["0x0p+0"] * dimension}}).encode() + b"\n"


def seq(line):
    return json.loads(line)["seq"]


def hello(text=b'{"name":"x"}\n'):
    sys.stdin.buffer.readline()
    send(text)


def each(act):
    hello()
    for line in sys.stdin.buffer:
        act(line)


def at_once(act):
    return lambda: act(b"")


def sleep(_=None):
    while True:
        time.sleep(1000)


def crash(_=None):
    os.kill(os.getpid(), signal.SIGSEGV)


def flood(block, target=1, pause=0):
    def act(_):
        while True:
            os.write(target, block)
            time.sleep(pause)
    return act


def fork_and(parent, *, session=False, closes=False):
    """A child that holds our pipes, or hides from them, and a parent that does something else."""
    def act(line):
        if os.fork() == 0:
            if session:
                os.setsid()
            if closes:
                for descriptor in range(3):
                    os.close(descriptor)
            sleep()
        parent(line)
    return act


def grandchildren(line):
    """Three generations, each in a session of its own."""
    for _ in range(3):
        if os.fork() != 0:
            sleep()
        os.setsid()
    sleep()


def close_and_sleep(*descriptors):
    def act(_):
        for descriptor in descriptors:
            os.close(descriptor)
        sleep()
    return act


def deaf(_):
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    sleep()


def drip(line):
    for byte in right(line):
        send(bytes([byte]))
        time.sleep(0.3)


def noisy(line):
    for _ in range(50):
        os.write(2, b"E" * 65536)
    send(right(line))


DEEP = b"[" * 200000 + b"]" * 200000

MODES = {
    # before hello
    "exit_at_once": at_once(lambda _: os._exit(3)),
    "crash_at_once": at_once(crash),
    "flood_before_hello": at_once(flood(b"x" * 65536)),
    "flood_lines_before_hello": at_once(flood(b'[1]\n' * 5000)),
    "hello_nonsense": lambda: (hello(b"\x1b[31m\xff\x00nonsense\n"), sleep()),
    "hello_huge_bits": lambda: (hello(b'{"name":"x","bits":1e300}\n'), sleep()),
    "hello_no_bits": lambda: (hello(b'{"name":"x","bits":0}\n'), sleep()),
    "hello_bits_in_words": lambda: (hello(b'{"name":"x","bits":"many"}\n'), sleep()),
    # instead of a reply
    "crash": lambda: each(crash),
    "abort": lambda: each(lambda _: os.abort()),
    "exit": lambda: each(lambda _: os._exit(7)),
    "exit_0": lambda: each(lambda _: os._exit(0)),
    "hang": lambda: each(sleep),
    "partial": lambda: each(lambda _: (send(b'{"seq":1,"out"'), sleep())),
    "partial_exit": lambda: each(lambda _: (send(b'{"seq":1,"out"'), os._exit(0))),
    "drip": lambda: each(drip),
    "deaf": lambda: each(deaf),
    "stopped": lambda: each(lambda _: os.kill(os.getpid(), signal.SIGSTOP)),
    "close_stdin": lambda: each(close_and_sleep(0)),
    "close_stdout": lambda: each(close_and_sleep(1)),
    "close_both": lambda: each(close_and_sleep(0, 1)),
    # descendants
    "fork_crash": lambda: each(fork_and(crash)),
    "fork_exit": lambda: each(fork_and(lambda _: os._exit(5))),
    "fork_hang": lambda: each(fork_and(sleep)),
    "session_crash": lambda: each(fork_and(crash, session=True)),
    "session_hang": lambda: each(fork_and(sleep, session=True)),
    "daemon_exit": lambda: each(fork_and(lambda _: os._exit(0), session=True, closes=True)),
    "daemon_hang": lambda: each(fork_and(sleep, session=True, closes=True)),
    "grandchildren": lambda: each(grandchildren),
    # its parent
    "kill_parent": lambda: each(lambda _: (os.kill(os.getppid(), signal.SIGTERM), sleep())),
    "kill_parent_outright": lambda: each(lambda _: (os.kill(os.getppid(), signal.SIGKILL), sleep())),
    "kill_the_group": lambda: each(lambda _: os.killpg(os.getpgid(0), signal.SIGKILL)),
    # garbage
    "not_json": lambda: each(lambda _: send(b"Traceback\n")),
    "nul": lambda: each(lambda _: send(b'{"seq":1,\x00"out":{}}\n')),
    "nul_after": lambda: each(lambda line: send(right(line)[:-1] + b"\x00garbage\n")),
    "not_utf8": lambda: each(lambda line: send(b'{"seq":%d,"out":"\xff\xfe"}\n' % seq(line))),
    "escapes": lambda: each(lambda _: send(b"\x1b[31mRED\x1b]0;pwned\x07\n")),
    "wrong_seq": lambda: each(lambda _: send(b'{"seq":99999,"out":{}}\n')),
    "deep": lambda: each(lambda line: send(b'{"seq":%d,"out":' % seq(line) + DEEP + b"}\n")),
    "null": lambda: each(lambda _: send(b"null\n")),
    "empty": lambda: each(lambda _: send(b"\n")),
    "empty_out": lambda: each(lambda line: send(b'{"seq":%d,"out":{}}\n' % seq(line))),
    "nan": lambda: each(lambda line: send(b'{"seq":%d,"out":{"dp":["nan","nan"]}}\n' % seq(line))),
    "flood": lambda: each(flood(b"x" * 65536)),
    "flood_lines": lambda: each(flood(b'{"seq":1,"out":{}}\n' * 5000)),
    "flood_stderr": lambda: each(flood(b"E" * 65536, 2, 0.002)),
    # right, in a way
    "noisy": lambda: each(noisy),
    "crlf": lambda: each(lambda line: send(right(line)[:-1] + b"\r\n")),
    "right": lambda: each(lambda line: send(right(line))),
}

if __name__ == "__main__":
    MODES[sys.argv[1]]()
