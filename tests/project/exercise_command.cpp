/// ./course exercise, as a student calls it.
#include <csignal>
#include <thread>

#include "pushback/tools/classroom/student_files.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Exercise& slop() {
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "04");
}

const std::string right =
                      "normal.bias = normal.separation > 0 ? normal.separation / h\n"
                      "                                    : beta / h * std::min(Real(0), normal.separation + slop);\n",
                  wrong_lines =
                      "normal.bias = normal.separation > -slop ? normal.separation / h\n"
                      "                                        : beta / h * (normal.separation + slop);\n";

struct Student {
  Scratch scratch;
  Ended call(const std::string& words) {
    return call_program(EXERCISE_PROGRAM, words + " --in " + (scratch / "").string(), 120);
  }
  void write(const std::string& lines) { write_text_file(scratch / "04_slop.h", filled_in(slop(), lines)); }
};

}  // namespace

TEST_CASE("the way of a student: the file, the gap, hints, a wrong answer, the right one, the next exercise") {
  Student student;
  CHECK(contains(student.call("").out, "next: ./course exercise 00\n"));
  const Ended first = student.call("4");
  CHECK(first.status == 0);
  CHECK(contains(first.out, "04_slop.h; the gap is in line 16. The task is "));
  CHECK(text_of(student.scratch / "04_slop.h") == text_of(stub_of(slop())));
  const Ended untouched = student.call("slop");
  CHECK(untouched.status == 1);
  CHECK(contains(untouched.out, "Nothing is written yet."));
  CHECK_FALSE(contains(student.call("04 --hint").out, "  2. "));
  CHECK(contains(student.call("04 --hint").out, "  2. " + slop().hints[1]));

  student.write("std::puts(\"here\"); " + wrong_lines);
  const Ended wrong = student.call("04 --seed 5");
  CHECK(wrong.status == 1);
  CHECK(contains(wrong.out, "  ✓ a body that would pass through the surface in this step ends on it\n"));
  CHECK(contains(wrong.out, "  ✗ an overlap up to the slop stays, and a deeper body comes up at β (d − slop) / h\n"));
  CHECK(contains(wrong.out, "  | here\n"));
  CHECK(contains(wrong.out, "Your ball, which is sinking but less deep than the slop, continues at "));
  CHECK(contains(wrong.out, slop().checks[2].hint));
  CHECK(student.call("04 --seed 5").out == wrong.out);
  CHECK(contains(student.call("").out, "04           begun"));

  student.write(right);
  const Ended solved = student.call("04");
  CHECK(solved.status == 0);
  CHECK(contains(solved.out, "  Solved.\n"));
  CHECK(contains(student.call("").out, "04           solved"));

  CHECK(student.call("04 --reset").status == 0);
  CHECK(text_of(student.scratch / "04_slop.h") == text_of(stub_of(slop())));
  CHECK(contains(student.call("04 --reset").out, "04_slop.h.old2\n"));
  CHECK(text_of(student.scratch / "04_slop.h.old") == filled_in(slop(), right));
}

TEST_CASE("a folder that is mistyped is named, and none is made") {
  const Scratch scratch;
  const std::string typed = (scratch / "misttyped").string();
  for (const std::string words : {"04 --in ", "04 --reset --in ", "--in "}) {
    const Ended ended = call_program(EXERCISE_PROGRAM, words + typed);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, "misttyped' does not exist: a folder that exists is needed."));
  }
  CHECK_FALSE(fs::exists(typed));
  const Ended file = call_program(EXERCISE_PROGRAM, "04 --in /etc/passwd");
  CHECK(file.status == 2);
  CHECK(contains(file.err, "passwd' is no folder: a folder that exists is needed."));
}

TEST_CASE("watched, a file is checked at each save") {
  Student student;
  student.write(lines_of_the_gap(slop()));
  const fs::path done = student.scratch / "done";
  std::jthread hand([&] {
    std::this_thread::sleep_for(std::chrono::seconds(2));
    fs::remove(student.scratch / "04_slop.h");            // as some editors save
    fs::create_directory(student.scratch / "04_slop.h");  // there, and not to be read
    std::this_thread::sleep_for(std::chrono::seconds(1));
    fs::remove(student.scratch / "04_slop.h");
    student.write(right);
    for (int i = 0; i < 50 && !StudentFiles(student.scratch / "").solved(slop()); ++i)
      std::this_thread::sleep_for(std::chrono::seconds(1));
    std::this_thread::sleep_for(std::chrono::seconds(1));  // it goes on
    write_text_file(done, "");
  });
  const Ended ended =
      run_program({"sh", "-c", "\"$@\" & until [ -e \"$0\" ]; do sleep 1; done; kill $!; wait $!", done.string(),
                   EXERCISE_PROGRAM, "04", "--watch", "--in", (student.scratch / "").string()},
                  60);
  CHECK(ended.status == 128 + SIGTERM);  // it goes on until it is ended
  CHECK(contains(ended.out, "Nothing is written yet."));
  CHECK(contains(ended.out, "Solved."));
  CHECK(ended.out.find("Nothing is written yet.") < ended.out.find("Solved."));
}
