/// ./course grade and ./course run handout: many students, a table, JUnit XML and JSON, in parts and taken up again.
#include <map>
#include <set>

#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/grade.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Exercise& capped() {
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "03");
}

/// A class of five: one right, one without a cap, one with a link to the first, one with nothing, one who changes nothing.
struct Class {
  Scratch scratch;
  std::string folders;
  Class() {
    write("anna", "normal.bias = std::min(normal.bias, std::max(-cap, beta / h * normal.separation));\n");
    write("ben & co", "normal.bias = std::min(normal.bias, beta / h * normal.separation);\n");
    fs::create_directories(scratch / "carl");
    fs::create_symlink(scratch / "anna/03_baumgarte.h", scratch / "carl/03_baumgarte.h");
    fs::create_directories(scratch / "dora");
    write("eve", "static constexpr int nothing = 1;\n");
    for (const std::string name : {"anna", "ben & co", "carl", "dora", "eve"})
      folders += "'" + (scratch / name).string() + "' ";
  }
  void write(const std::string& name, const std::string& lines) {
    fs::create_directories(scratch / name);
    write_text_file(scratch / name / "03_baumgarte.h", filled_in(capped(), lines));
  }
  Ended grade(const std::string& more) {
    return call_program(GRADE_PROGRAM,
                        folders + "--exercises 03 --no-sandbox --out " + (scratch / "out").string() + " " + more, 120);
  }
};

}  // namespace

TEST_CASE("a class is graded: a table, JSON and JUnit XML, and again, only what has changed") {
  Class all;
  CHECK(all.grade("--shard 1/2").err == "graded: anna\ngraded: carl\ngraded: eve\n");
  const Ended first = all.grade("--jobs 2");
  CHECK(first.status == 0);
  CHECK(contains(first.out, "anna        6 of 6  03 6/6\n"));
  CHECK(contains(first.out, "ben & co    4 of 6  03 4/6"));
  CHECK(contains(first.out, "carl        0 of 6  03 0/6 (not handed in)\n"));
  CHECK(contains(first.out, "dora        0 of 6  03 0/6 (not handed in)\n"));
  CHECK(contains(first.out, "eve         0 of 6  03 0/6 (nothing changes)\n"));
  const std::string xml = text_of(all.scratch / "out/results.xml");
  CHECK(contains(xml, "<testsuite name=\"anna\" tests=\"4\" failures=\"0\">"));
  CHECK(contains(xml, "<testsuite name=\"ben &amp; co\" tests=\"4\" failures=\"1\">"));
  CHECK(contains(xml, "<failure message=\"your ball, which is more than a metre deep, leaves at"));
  const Ended second = all.grade("");
  CHECK(second.err.empty());
  CHECK(second.out == first.out);
  all.write("dora", "normal.bias += 0\n");
  const Ended third = all.grade("");
  CHECK(third.err == "graded: dora\n");
  CHECK(contains(third.out, "03 0/6 (does not compile)"));
  write_text_file(all.scratch / "points", "# all on the cap\n03 1 0\n03 2 10  # the cap\n03 3 0\n03 4 0\n");
  const Ended fourth = all.grade("--points " + (all.scratch / "points").string());
  CHECK(contains(fourth.out, "anna       10 of 10  03 10/10\n"));
  CHECK(contains(fourth.out, "ben & co    0 of 10"));
}

namespace {

/// The plain loop of 06 as a class of whole solvers: right, without a clamp, with nothing, with a crash, as a link, in an archive.
struct Solvers {
  Scratch scratch;
  std::string folders;
  Solvers() {
    const std::string right = plain_loop(6);
    std::string pulls = right;
    pulls.replace(pulls.find("normal.lo = 0;"), 14, "");
    write("anna", "mine/solver.h", "#include \"mu.h\"\n" + right);
    write("anna", "mine/mu.h", "#pragma once\n");
    write("ben", "solver.h", pulls);
    write("carl", "mine/solver.h", begins + "override {}\n};\n");
    write("dora", "mine/solver.h", "#include <cstdlib>\n" + begins + "override { std::abort(); }\n};\n");
    write("eve", "mine/solver.h", begins + "override { int x = ; }\n};\n");
    fs::create_directories(scratch / "frank/mine");
    fs::create_symlink(scratch / "anna/mine/solver.h", scratch / "frank/mine/solver.h");
    write("gina", "mine/solver.h", "#include \"stolen.h\"\n" + begins + "override {}\n};\n");
    fs::create_symlink(scratch / "anna/mine/solver.h", scratch / "gina/mine/stolen.h");
    REQUIRE(run_program({"tar", "-czf", scratch / "hana.tar.gz", "-C", scratch / "anna", "mine"}).status == 0);
    folders += "'" + (scratch / "hana.tar.gz").string() + "' ";
  }
  void write(const std::string& name, const std::string& file, const std::string& text) {
    if (!fs::exists(scratch / name)) folders += "'" + (scratch / name).string() + "' ";
    fs::create_directories((scratch / name / file).parent_path());
    write_text_file(scratch / name / file, text);
  }
  static inline const std::string begins =
      "#include \"pushback/common/world/step_solver.h\"\nstruct MySolver : pushback::StepSolver {\n"
      "  void solve(pushback::World&, pushback::Real, int) ";
};

}  // namespace

TEST_CASE("a class's own solvers are graded up to a chapter: where each stands, and why it goes no further",
          "[checked]") {
  Solvers all;
  const fs::path points = all.scratch / "handout.points";
  CHECK(call_program(HANDOUT_PROGRAM, (all.scratch / "handout").string() + " --with 03 --mine 06").status == 0);
  std::string only_mine;
  for (const std::string& line : lines_of(text_of(points)))
    if (line.starts_with("mine_06 ")) only_mine += line + "\n";
  CHECK(lines_of(only_mine).size() == 22);
  write_text_file(points, only_mine);
  const auto grade = [&] {
    return call_program(GRADE_PROGRAM,
                        all.folders + "'" + (all.scratch / "frank").string() +
                            "' --no-sandbox --jobs 2 --seed 1 --points " + points.string() + " --out " +
                            (all.scratch / "out").string(),
                        120);
  };
  const Ended first = grade();
  INFO(first.out << first.err);
  CHECK(first.status == 0);
  for (const char* line :
       {"anna      22 of 22  mine_06 22/22, stands at 06\n", "ben        4 of 22  mine_06 4/22, stands at 01",
        "carl       0 of 22  mine_06 0/22, stands at none", "dora       0 of 22  mine_06 0/22, stands at none (crash)",
        "eve        0 of 22  mine_06 0/22, stands at none (does not compile)",
        "frank      0 of 22  mine_06 0/22, stands at none (not handed in)",
        "gina       0 of 22  mine_06 0/22, stands at none (does not compile)",
        "hana      22 of 22  mine_06 22/22, stands at 06\n"})
    CHECK(contains(first.out, line));
  CHECK(grade().err.empty());
  all.write("anna", "mine/mu.h", "#error\n");  // a header counts as the file does
  CHECK(grade().err == "graded: anna\n");
  CHECK(call_program(HANDOUT_PROGRAM, (all.scratch / "none").string() + " --mine 99").status == 2);
  CHECK_FALSE(fs::exists(all.scratch / "none"));
}

TEST_CASE(
    "an archive is graded as the folder in it, and one that leads elsewhere is not taken, nor one that is too much",
    "[checked]") {
  Class all;
  const auto shell = [&](const std::string& commands) {
    const Ended ended =
        run_program({"sh", "-ec", "cd " + (all.scratch / "").string() + "; mkdir -p in; " + commands}, 60);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
  };
  shell(
      "cd anna; zip -q ../in/flat.zip *; cd ..\n"
      "mkdir 'x [1]*'; cp -r anna 'x [1]*/exercises'; zip -qr in/deep.zip 'x [1]*'; tar -czf in/deep2.tar.gz 'x [1]*'\n"
      "tar -cPf in/dots.tar ../$(basename $PWD)/anna; tar -cPf in/absolute.tar $PWD/anna\n"
      "zip -qry in/link.zip carl; tar -cf in/link2.tar carl\n"
      "mkdir linked; ln -s $PWD/anna linked/exercises; tar -cf in/link3.tar linked\n"
      "mkdir 'back\\slash'; cp anna/* 'back\\slash'; tar --no-unquote -cf in/escaped.tar 'back\\slash'\n"
      "mkdir twice; cp -r anna twice/a; cp -r anna twice/b; zip -qr in/twice.zip twice; tar -cf in/twice2.tar twice\n"
      "mkdir large; truncate -s 3G large/03_baumgarte.h; tar -Scf in/large.tar large; tar -czf in/large2.tgz "
      "-S large\n"
      "mkdir many; cd many; touch $(seq 1500); cd ..; zip -qr in/many.zip many; tar -cf in/many2.tar many\n"
      "printf junk >in/junk.zip; printf junk >in/junk2.tar.gz; cd anna; zip -q -P secret ../in/secret.zip *");
  std::string archives;
  for (const auto& entry : fs::directory_iterator(all.scratch / "in")) archives += entry.path().string() + " ";
  const std::string before =
      run_program({"sh", "-c", "cd " + (all.scratch / "").string() + "; find . -type f -newer in | sort"}).out;
  const std::string options = " --no-sandbox --out " + (all.scratch / "out").string();
  const Ended ended = call_program(GRADE_PROGRAM, archives + options, 120);
  CHECK(ended.status == 0);
  const auto graded = [&](const std::string& student, const std::string& as) {
    INFO(student << ": " << ended.out);
    bool said = false;
    for (const std::string& line : lines_of(ended.out))
      said = said || (line.starts_with(student + " ") && contains(line, as));
    CHECK(said);
  };
  for (const std::string right : {"flat", "deep", "deep2"}) graded(right, "03 6/6");
  for (const std::string none : {"link", "link2", "link3"}) graded(none, "03 0/6 (not handed in)");
  for (const std::string bad : {"dots", "absolute", "escaped", "twice", "twice2", "large", "large2", "many", "many2",
                                "junk", "junk2", "secret"})
    graded(bad, "03 0/6 (not taken)");
  const std::string json = text_of(all.scratch / "out/results.json");
  for (const char* why : {"leads out of its folder", "it has 1501 entries, at most 1000 are taken", "it cannot be read",
                          "there are 2 files 03_baumgarte.h in it", "is larger than 1 MB"})
    CHECK(contains(json, why));
  CHECK(call_program(GRADE_PROGRAM, archives + options, 120).err.empty());  // taken up again: nothing to do
  fs::remove_all(all.scratch / "out");
  CHECK(run_program({"sh", "-c", "cd " + (all.scratch / "").string() + "; find . -type f -newer in | sort"}).out ==
        before);
}

TEST_CASE("what a student's name would do to a terminal or to a file of results is spelled out") {
  Class all;
  const std::string evil = "a\x1b[2Jb\r\n\x7f\xc2\x9b\xe2\x80\xae\xff";
  fs::rename(all.scratch / "anna", all.scratch / evil);
  REQUIRE(run_program({"tar", "-cf", all.scratch / (evil + ".x.tar"), "-C", all.scratch / "", evil}).status == 0);
  write_text_file(all.scratch / ("stray" + evil), "");
  std::vector<std::string> command{GRADE_PROGRAM, "--exercises", "03", "--no-sandbox", "--out", all.scratch / "out"};
  for (const std::string& name : {evil, evil + ".x.tar", "stray" + evil, std::string("dora")})
    command.push_back(all.scratch / name);
  const Ended ended = run_program(command, 120);
  const std::string spelled = R"(a\x1b[2Jb\x0d\x0a\x7f\xc2\x9b\xe2\x80\xae\xff)";
  CHECK(contains(ended.out, spelled + "    "));
  CHECK(contains(ended.out, spelled + ".x  "));
  CHECK(contains(ended.err, "stray" + spelled + "' is no folder"));
  for (const std::string& text :
       {ended.out, ended.err, text_of(all.scratch / "out/results.json"), text_of(all.scratch / "out/results.xml")})
    for (const std::string raw : {"\x1b", "\r", "\x7f", "\xc2\x9b", "\xe2\x80\xae", "\xff"}) {
      INFO(text);
      CHECK_FALSE(contains(text, raw));
    }
}

TEST_CASE("what cannot be graded is refused, and nothing is left behind") {
  Class all;
  CHECK(call_program(GRADE_PROGRAM, "nowhere --out " + (all.scratch / "out").string()).status == 2);
  CHECK(contains(all.grade("'" + (all.scratch / "anna/").string() + "'").err, "two students are named 'anna'"));
  for (const std::string shard : {"0/2", "3/2", "1", "1/", "a/b", "1/2x"}) {
    const Ended ended = all.grade("--shard " + shard);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, "--shard is '" + shard + "'"));
  }
  for (const std::string line : {"03 5 1", "03 0 1", "03 1 -1", "03 1 2000000000", "03 1", "99 1 1", "03 1 1 1"}) {
    write_text_file(all.scratch / "points", "\n" + line + "\n");
    CHECK(all.grade("--points " + (all.scratch / "points").string()).status == 2);
  }
  CHECK_FALSE(fs::exists(all.scratch / "out"));
}

TEST_CASE("without a sandbox nothing is graded, unless that is said") {
  Class all;
  fs::create_directories(all.scratch / "bin");
  for (const std::string tool : {"timeout", "env"}) fs::create_symlink("/usr/bin/" + tool, all.scratch / "bin" / tool);
  const Ended ended = run_program({"env", "PATH=" + (all.scratch / "bin").string(), GRADE_PROGRAM,
                                   (all.scratch / "anna").string(), "--out", (all.scratch / "out").string()},
                                  60);
  CHECK(ended.status == 2);
  CHECK(contains(ended.err, "install the package bubblewrap, or say --no-sandbox"));
  CHECK_FALSE(fs::exists(all.scratch / "out"));
}

TEST_CASE("a handout has tasks and gaps, and neither answers nor checks, and its points can be edited") {
  const Scratch scratch;
  const std::string folder = (scratch / "handout").string();
  const Ended ended = call_program(HANDOUT_PROGRAM, folder + " --with 03,15-transfer,04 --without 04");
  CHECK(ended.status == 0);
  const std::string broken = "15_limits_motors_springs_transfer";
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.insert(entry.path().filename().string());
  CHECK(files == std::set<std::string>{"03_baumgarte.h", "03_baumgarte.md", broken + ".h", broken + ".md",
                                       "CMakeLists.txt", "README.md"});
  for (const std::string& name : {std::string("03_baumgarte"), broken}) {
    const std::string gap = text_of(scratch / ("handout/" + name + ".h"));
    CHECK(untouched(gap, read_text_file(stub_of(exercise_named(all_exercises(), name)))));
  }
  const Points points(all_exercises(), scratch / "handout.points");
  for (std::size_t i = 0; i < capped().checks.size(); ++i) CHECK(points.of(capped(), i) == capped().checks[i].points);
  CHECK(call_program(HANDOUT_PROGRAM, folder).status == 2);
  CHECK(call_program(HANDOUT_PROGRAM, (scratch / "none").string() + " --with 03 --without 03").status == 2);
  CHECK_FALSE(fs::exists(scratch / "none"));
}
