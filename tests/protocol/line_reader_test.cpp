// Lines from a pipe: when they come, in what pieces, and what is too long.
#include "reference/text/line_reader.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <thread>

#include "reference/text/input_error.hpp"

namespace tps::protocol {
namespace {

using Status = LineReader::Status;

class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close_writer();
    ::close(ends_[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  void write(const std::string& text) const {
    ASSERT_EQ(::write(ends_[1], text.data(), text.size()), std::ssize(text));
  }
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

bool never() {
  return false;
}

TEST(LineReader, GivesLinesWithoutTheirEnds) {
  Pipe pipe;
  pipe.write("one\n\ntwo\r\nlast");
  pipe.close_writer();
  LineReader reader(
      "the pipe", pipe.reader(), 100, [] {}, never);
  for (const char* expected : {"one", "", "two", "last"}) {
    const LineReader::Result line = reader.next();
    EXPECT_EQ(line.status, Status::line);
    EXPECT_EQ(line.text, expected);
  }
  EXPECT_EQ(reader.next().status, Status::end);
}

// Whatever is there is handed out before the wait is announced; a wait is announced once a block.
TEST(LineReader, AnnouncesAWaitOnlyWhenNothingIsThere) {
  Pipe pipe;
  pipe.write("a\nb\nc");
  int waits = 0;
  LineReader reader(
      "the pipe", pipe.reader(), 100, [&] { ++waits; }, never);
  EXPECT_EQ(reader.next().text, "a");
  EXPECT_EQ(waits, 1);
  EXPECT_EQ(reader.next().text, "b");
  EXPECT_EQ(waits, 1);
  pipe.write("d\n");
  EXPECT_EQ(reader.next().text, "cd");
  EXPECT_EQ(waits, 2);
}

TEST(LineReader, PassesOverLinesThatAreTooLong) {
  Pipe pipe;
  std::thread writer([&pipe] {
    pipe.write(std::string(200000, 'x') + "\n" + std::string(10, 'y') + "\n" + std::string(11, 'z') +
               "\nend\n" + std::string(30, 'w'));
    pipe.close_writer();
  });
  LineReader reader(
      "the pipe", pipe.reader(), 10, [] {}, never);
  const LineReader::Result first = reader.next();
  EXPECT_EQ(first.status, Status::too_long);
  EXPECT_EQ(first.text, std::string(60, 'x'));
  EXPECT_EQ(reader.next().text, std::string(10, 'y'));
  EXPECT_EQ(reader.next().status, Status::too_long);
  EXPECT_EQ(reader.next().text, "end");
  EXPECT_EQ(reader.next().status, Status::too_long);
  EXPECT_EQ(reader.next().status, Status::end);
  writer.join();
}

TEST(LineReader, StopsWhenTold) {
  Pipe pipe;
  LineReader reader(
      "the pipe", pipe.reader(), 10, [] {}, [] { return true; });
  EXPECT_EQ(reader.next().status, Status::interrupted);
}

TEST(LineReader, SaysWhyItCannotRead) {
  const int directory = ::open("/", O_RDONLY);
  LineReader reader(
      "questions.jsonl", directory, 10, [] {}, never);
  try {
    reader.next();
    ADD_FAILURE() << "a directory was read";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "questions.jsonl: cannot be read: Is a directory");
  }
  ::close(directory);
}

}  // namespace
}  // namespace tps::protocol
