/// A teacher's own exercises, in a folder outside the project: listed, handed out, checked and graded as ours are.
#include "pushback/tools/classroom/own_tasks.h"
#include "pushback/common/basics/input.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// The example, in a folder of its own.
struct Tasks {
  Scratch scratch;
  fs::path brake = scratch / "tasks/brake";
  std::string folder = (scratch / "tasks").string(), with = " --tasks " + folder;
  Tasks() {
    fs::create_directories(brake);
    for (const auto& entry : fs::directory_iterator(SOURCE_DIR "/tests/own_tasks/brake"))
      fs::copy_file(entry.path(), brake / entry.path().filename());
  }
  void write(const std::string& student, const std::string& lines) {
    const std::string stub = text_of(brake / "student.h");
    const std::size_t from = stub.rfind('\n', stub.find("TODO")) + 1, to = stub.rfind('\n', stub.find("TODO ends"));
    fs::create_directories(scratch / student);
    write_text_file(scratch / (student + "/brake.h"), stub.substr(0, from) + lines + stub.substr(to));
  }
};

const std::string right = "return std::clamp(-mass * speed, -strength * h, strength * h);\n",
                  unbounded = "return -mass * speed;\n";

}  // namespace

TEST_CASE("an exercise of one's own is listed, checked, handed out and graded beside ours, and compiled once") {
  Tasks tasks;
  tasks.write("anna", unbounded);
  const std::string anna = " --in " + (tasks.scratch / "anna").string();
  const Ended listed = call_program(EXERCISE_PROGRAM, anna + tasks.with, 120);
  CHECK(contains(listed.err, "compiling the task brake"));
  CHECK(contains(listed.out, "  brake        begun   own: a brake of bounded strength (3 points)\n"));
  CHECK(contains(listed.out, "  15-transfer "));
  const Ended wrong = call_program(EXERCISE_PROGRAM, "brake" + anna + tasks.with, 120);
  CHECK(wrong.err.empty());
  CHECK(wrong.status == 1);
  CHECK(contains(wrong.out, "  ✗ a wagon that can be stopped stands, and stays\n"));
  CHECK(contains(wrong.out, "the brake gives -m v where that is less than F h"));
  tasks.write("anna", right);
  CHECK(contains(call_program(EXERCISE_PROGRAM, "brake" + anna + tasks.with, 120).out, "Solved."));

  tasks.write("ben", unbounded);
  const Ended graded =
      call_program(GRADE_PROGRAM,
                   (tasks.scratch / "anna").string() + " " + (tasks.scratch / "ben").string() + tasks.with +
                       " --exercises brake --no-sandbox --out " + (tasks.scratch / "out").string(),
                   120);
  CHECK(contains(graded.out, "anna       3 of 3  brake 3/3\n"));
  CHECK(contains(graded.out, "brake 0/3\n"));
  const Ended handout =
      call_program(HANDOUT_PROGRAM, (tasks.scratch / "handout").string() + " --with brake" + tasks.with, 120);
  CHECK(handout.status == 0);
  CHECK(text_of(tasks.scratch / "handout/brake.h") == text_of(tasks.brake / "student.h"));
  CHECK(contains(text_of(tasks.scratch / "handout.points"), "brake 3 1  # a wagon that rolls backwards"));
}

TEST_CASE("a file may not read what is right of an exercise of one's own") {
  if (!has_sandbox()) return;
  const Sandbox sandbox;
  Tasks tasks;
  const std::vector<Exercise> all = exercises_with(tasks.folder);
  const Exercise& exercise = exercise_named(all, "brake");
  CHECK(verdict_on(exercise, filled_in(exercise, right), 1, &sandbox).passed());
  const std::string checks = (tasks.brake / "checks.cpp").string();
  for (const std::string& file : {checks, std::string("checks.cpp")})
    CHECK(verdict_on(exercise, "#include \"" + file + "\"\n" + filled_in(exercise, right), 1, &sandbox).mistake ==
          "does not compile");
  const std::string reads = "static const bool read = std::ifstream(\"" + checks + "\").good();\nif (read) return 0;\n";
  CHECK(verdict_on(exercise, "#include <fstream>\n" + filled_in(exercise, reads + right), 1, &sandbox).passed());
}

TEST_CASE("what is wrong with a folder of tasks is said") {
  Tasks tasks;
  const auto refused = [](const fs::path& folder, const std::string& words) {
    try {
      exercises_with(folder);
      FAIL("taken: " << folder.string());
    } catch (const InvalidInput& problem) {
      INFO(problem.what());
      CHECK(contains(problem.what(), words));
    }
  };
  refused(tasks.scratch / "nowhere", "nowhere' is no folder");
  fs::create_directories(tasks.scratch / "empty");
  refused(tasks.scratch / "empty", "has no exercises");
  fs::rename(tasks.brake, tasks.scratch / "tasks/03_baumgarte");
  refused(tasks.folder, "an exercise named 03_baumgarte already exists");
  fs::rename(tasks.scratch / "tasks/03_baumgarte", tasks.brake);
  write_text_file(tasks.brake / "checks.cpp", text_of(tasks.brake / "checks.cpp") + "int main( {\n");
  refused(tasks.folder, "brake does not compile:");
  fs::remove(tasks.brake / "task.md");
  refused(tasks.folder, "brake has no task.md");
  fs::rename(tasks.brake, tasks.scratch / "tasks/The Brake");
  write_text_file(tasks.scratch / "tasks/The Brake/task.md", "");
  refused(tasks.folder, "a folder is named 'The Brake'");
}
