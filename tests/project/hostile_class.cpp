/// ./course grade on a class that attacks it: hostile_class.txt says what each hands in, and what is due to it.
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <set>

#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

struct Student {
  std::string name;
  int points = 0;
  std::string mistake, words, above, inside;
};

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

std::vector<Student> students() {
  std::vector<Student> all;
  const auto add = [&](const std::string& code) {
    if (code.starts_with("^ ")) all.back().above += code.substr(2) + "\n";
    else all.back().inside += code + "\n";
  };
  for (const std::string& line : lines_of(text_of(SOURCE_DIR "/tests/project/hostile_class.txt"))) {
    std::vector<std::string> parts(5);
    std::istringstream in(line);
    for (std::size_t i = 0; i < 4; ++i) std::getline(in, parts[i], '|');
    std::getline(in, parts[4]);
    for (std::string& part : parts) part = trimmed(part);
    if (line.starts_with("  ") && !all.empty()) add(trimmed(line));
    else if (parts[1] == "0" || parts[1] == "6") {
      all.push_back({parts[0], std::stoi(parts[1]), parts[2], parts[3], "", parts[1] == "6" ? "@RIGHT@\n" : ""});
      add(parts[4]);
    }
  }
  REQUIRE(all.size() > 50);
  return all;
}

/// MUST_NOT: see hostile_class.txt. BEFORE_MAIN: code that knows the word with which an answer begins.
constexpr const char* everywhere = R"(#include <arpa/inet.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#define MUST_NOT(...) \
  if (__VA_ARGS__) std::fprintf(stderr, "done: %s\n", #__VA_ARGS__), _exit(9)
#define BEFORE_MAIN(word)                         \
  static void forge(word);                        \
  __attribute__((constructor)) static void go() { \
    char text[200] = {}, word_of_the_run[40] = {};\
    pread(0, text, sizeof text - 1, 0);           \
    sscanf(text, "%39s", word_of_the_run);        \
    forge(word_of_the_run);                       \
    _exit(0);                                     \
  }                                               \
  static void forge(word)
)";

/// A folder for each in scratch/class, and beside it what a teacher has.
class HostileClass {
 public:
  HostileClass() : exercises_(all_exercises()), asked_(exercise_named(exercises_, "03")) {
    write_text_file(make("home") / "secret.txt", "key-of-the-teacher\n");
    const std::string right = "normal.bias = std::min(normal.bias, std::max(-cap, beta / h * normal.separation));\n";
    hand_in({"a right one", 6, "", "", "", right});
    hand_in({"-rf", 6, "", "", "", right});
    for (const Student& student : students()) hand_in(student);
    const std::string file = asked_.name + ".h";
    fs::create_symlink(folder_ / "class/a right one" / file, make("class/a link") / file);
    REQUIRE(mkfifo((make("class/a pipe") / file).c_str(), 0600) == 0);
    make("class/a folder/" + file);
    for (const std::string name : {"a link", "a pipe", "a folder"}) {
      due_.push_back({name, 0, "not handed in", "there is no regular file", "", ""});
      names_.push_back("class/" + name);
    }
    write_text_file(folder_ / "class/stray.txt", "");
    names_.push_back("class/stray.txt");
  }
  /// Options, and what comes of them. The class is graded from its own folder, so that "-rf" looks like an option.
  Ended grade(const std::string& options) const {
    std::vector<std::string> command{"env", "-C", folder_ / "class", "SECRET_TOKEN=key-of-the-teacher", GRADE_PROGRAM};
    std::istringstream in(options + " --exercises 03 --seed 1 --out " + (folder_ / "out").string());
    for (std::string word; in >> word;) command.push_back(word);
    command.emplace_back("--");
    for (const std::string& name : names_) command.push_back(name.substr(6));
    return run_program(command, 1200);
  }
  nlohmann::json results() const { return nlohmann::json::parse(text_of(folder_ / "out/results.json")); }
  std::string all_that_is_left() const {
    return text_of(folder_ / "out/results.json") + text_of(folder_ / "out/results.xml");
  }
  const std::vector<Student>& due() const { return due_; }

 private:
  fs::path make(const std::string& name) const {
    fs::create_directories(folder_ / name);
    return folder_ / name;
  }
  void hand_in(const Student& student) {
    std::string text = filled_in(asked_, student.inside);
    text.insert(text.find('\n', text.find("asked.h\"")) + 1, everywhere + student.above);
    const fs::path own = folder_ / "";
    for (const auto& [mark, meant] : std::vector<std::pair<std::string, std::string>>{
             {"@RIGHT@", "normal.bias = std::min(normal.bias, std::max(-cap, beta / h * normal.separation));"},
             {"@KIT@", kit_folder()},
             {"@LIBRARY@", SCENES_LIBRARY},
             {"@SOURCES@", SOURCE_DIR},
             {"@CLASS@", own / "class"},
             {"@HOME@", own / "home"},
             {"@OUT@", own / "out"}})
      for (std::size_t at; (at = text.find(mark)) != std::string::npos;) text.replace(at, mark.size(), meant);
    write_text_file(make("class/" + student.name) / (asked_.name + ".h"), text);
    due_.push_back(student);
    names_.push_back("class/" + student.name);
  }
  static std::string kit_folder() {
    return fs::path(SCENES_LIBRARY).parent_path().parent_path().parent_path() / "exercise";
  }

  Scratch folder_;
  std::vector<Exercise> exercises_;
  const Exercise& asked_;
  std::vector<Student> due_;
  std::vector<std::string> names_;
};

std::set<std::string> running() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator("/proc"))
    if (fs::exists(entry.path() / "comm")) names.insert(text_of(entry.path() / "comm"));
  return names;
}

}  // namespace

TEST_CASE("a hostile class gets what is due") {
  if (!has_sandbox()) return;
  const HostileClass hostile;
  const Ended ended = hostile.grade("--jobs 2 --seconds 1 --megabytes 200 --compile-seconds 6");
  if (ended.status != 0) FAIL(ended.err);
  CHECK(contains(ended.err, "not graded: 'stray.txt' is no folder"));
  const nlohmann::json results = hostile.results();
  CHECK(results.size() == hostile.due().size());
  for (const Student& due : hostile.due()) {
    const auto found =
        std::find_if(results.begin(), results.end(), [&](const auto& one) { return one["student"] == due.name; });
    INFO(due.name);
    REQUIRE(found != results.end());
    const nlohmann::json& got = (*found)["exercises"][0];
    INFO(got["mistake"] << ": " << got["verdict"] << "\n" << got["printed"]);
    CHECK(got["points"] == due.points);
    if (!due.mistake.empty() || due.points == 6) CHECK(got["mistake"] == due.mistake);
    CHECK(contains(got["verdict"], due.words));
    CHECK(got["verdict"].get<std::string>().size() < 1500);
  }
  CHECK_FALSE(contains(hostile.all_that_is_left(), "key-of-the-teacher"));
  CHECK_FALSE(running().contains("outlives\n"));
}

TEST_CASE("a sandbox holds a few hundred processes, whoever watches it") {
  if (!has_sandbox()) return;
  const Sandbox sandbox;
  const ScratchFolder folder;
  const auto started = [&](int count) {
    return run_program(sandbox.around({"sh", "-c",
                                       "i=0; while [ $i -lt " + std::to_string(count) +
                                           " ]; do sleep 60 & i=$((i+1)); done; echo all"},
                                      folder.path, {}),
                       60);
  };
  CHECK(started(20).out == "all\n");
  const Ended many = started(2000);
  INFO(many.err);
  CHECK(many.out == "");
  CHECK(many.status != 0);
}

TEST_CASE("of the checks, a student's program can name what plays a scene, and holds nothing that is right") {
  const std::string weak = "WVu";  // each program has its own of these
  std::vector<std::string> plays;
  for (const std::string& line :
       lines_of(run_program({"nm", "--defined-only", "--extern-only", SCENES_LIBRARY}, 60).out)) {
    std::istringstream in(line);
    std::string at, kind, name;
    if (!(in >> at >> kind >> name) || contains(weak, kind)) continue;
    INFO(name);
    CHECK(contains(name, "9checks_ofERK"));
    plays.push_back(name);
  }
  CHECK(plays.size() == all_exercises().size());
  const Scratch scratch;
  const std::string program = (scratch / "program").string();
  std::size_t graded = 0;
  for (const Exercise& exercise : all_exercises()) {
    if (!exercise.graded()) continue;
    ++graded;
    std::string space = "exercise_" + short_name(exercise);
    std::replace(space.begin(), space.end(), '-', '_');
    const auto found = std::find_if(plays.begin(), plays.end(),
                                    [&](const std::string& one) { return contains(one, space + "9checks_ofERK"); });
    REQUIRE(found != plays.end());
    const std::string& play = *found;
    INFO(play);
    std::vector<std::string> link = kit().words_of("link.txt");
    link.insert(link.begin() + 1, {"-o", program, "-nostartfiles", "-Wl,-e," + play, "-Wl,-u," + play,
                                   "-Wl,--defsym=__dso_handle=0,--defsym=main=0"});
    REQUIRE(run_program(link, 60).status == 0);
    const std::string names = run_program({"nm", program}, 60).out;
    CHECK(contains(names, play));
    for (const char* known : {"_15right", "_18mistakes", "8exerciseEv"}) CHECK_FALSE(contains(names, known));
  }
  CHECK(graded > 10);
}
