// Other programs: what goes in, what comes out, how they end.
#include "pushback/common/basics/process.h"

#include <unistd.h>

#include <chrono>
#include <csignal>

#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("a program gets its words and its input as they are, and what it says comes back") {
  const Ended words = run_program({"printf", "%s\n", "two words", "$HOME", "'quoted'", "a;b", ""});
  CHECK(words.status == 0);
  CHECK(lines_of(words.out) == std::vector<std::string>{"two words", "$HOME", "'quoted'", "a;b", ""});
  CHECK(words.err.empty());
  std::string much(3'000'000, 'x');
  much += std::string("\0 end", 5);
  CHECK(run_program({"cat"}, 20, much).out == much);
  CHECK(run_program({"cat"}).out.empty());  // no input is an end, and not a wait
}

TEST_CASE("how a program ended is told: its status, what it said, no such program, a signal, too long") {
  const Ended failed = run_program({"sh", "-c", "echo out; echo err >&2; exit 7"});
  CHECK(failed.status == 7);
  CHECK(failed.out == "out\n");
  CHECK(failed.err == "err\n");
  CHECK(run_program({"no-such-program"}).status == 127);
  CHECK(failed.signal == 0);
  const Ended killed = run_program({"sh", "-c", "kill -ABRT $$"});
  CHECK(killed.status == -1);
  CHECK(killed.signal == SIGABRT);
  for (const int status : {124, 137}) {  // those of `timeout`, before the time is over
    const Ended early = run_program({"sh", "-c", "exit " + std::to_string(status)}, 20);
    CHECK(early.status == status);
    CHECK_FALSE(early.out_of_time);
  }
  const auto before = std::chrono::steady_clock::now();
  for (const std::vector<std::string>& sleeps :
       {std::vector<std::string>{"sleep", "60"},
        {"sh", "-c", "trap '' TERM; exec sleep 60"}}) {  // deaf to what it is asked
    const Ended slept = run_program(sleeps, 0.2);
    CHECK(slept.status == 124);
    CHECK(slept.out_of_time);
  }
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(30));
}

TEST_CASE("a program has none of our files open but its input and output") {
  const int file = dup(1);  // as another thread's could be
  REQUIRE(file > 2);
  const Ended ended =
      run_program({"sh", "-c", "for n in 3 4 5 6 7 8 9; do [ ! -e /proc/$$/fd/$n ] || echo $n; done"}, 20);
  close(file);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
}
