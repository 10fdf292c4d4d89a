/// A file that does not compile: the line of the student's file, and the first error in plain words.
#include <fmt/format.h>

#include "pushback/tools/classroom/all_exercises.h"
#include "pushback/tools/classroom/brackets.h"
#include "pushback/tools/classroom/compiler_words.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Exercise& example() {  // 03, whose gap is the body of a function
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "03");
}

/// What is wrong, in which line, and words that have to be said of it.
struct Broken {
  std::string lines;
  std::size_t line;
  std::string words;
};

/// The message of a compiler, said of line 1 of a student's file.
std::string of_message(const std::string& message) {
  const ScratchFolder folder;
  write_text_file(folder.path / "02.h", "first line\n");
  return first_error("In file included from <command-line>:\n/tmp/x/02.h:1:5: error: " + message + "\n",
                     folder.path / "02.h");
}

void says(const std::string& text, const Broken& broken) {
  const ScratchFolder folder;
  const Verdict verdict = verdict_on(example(), text, 1);
  INFO(text << "\n" << verdict.sentence);
  CHECK(verdict.mistake == "does not compile");
  CHECK(contains(verdict.sentence, fmt::format("it does not compile. Line {}: ", broken.line)));
  CHECK(contains(verdict.sentence, broken.words));
}

}  // namespace

TEST_CASE("a file that does not compile: its own line and plain words for what beginners slip on", "[checked]") {
  const std::string stub = read_text_file(stub_of(example()));
  const std::size_t first = line_of_todo(stub);
  const std::size_t last = lines_of(stub).size();  // with the closing brace of the namespace
  for (const Broken& broken : std::vector<Broken>{
           {"  const Real sum = normal.speed()\n  normal.apply(sum);\n", first, "a semicolon is missing"},
           {"  normal.apply(normal.speed())\n", first, "a semicolon is missing"},
           {"  for (int i = 0; i < 3; ++i {\n    normal.apply(0);\n  }\n", first, "this ( is never closed"},
           {"  for (\n", first, "this ( is never closed"},
           {"  normal.apply(0;\n", first, "this ( is never closed"},
           {"  if (normal.impulse > 0 {\n    normal.apply(0);\n  }\n", first, "this ( is never closed"},
           {"  if (normal.impulse > 0) {\n    normal.apply(0);\n", first, "this { is never closed"},
           {"  normal.apply(0);\n  }\n", first + 1, "this } closes nothing"},
           {"    normal.apply(0);\n    }\n", first + 1, "this } closes nothing"},
           {"  normal.apply(0));\n", first, "this ) closes nothing"},
           {"  const Real f[3] = {0, 1, 2;\n  normal.apply(f[0]);\n", first, "this { is never closed"},
           {"#if 1\n  normal.apply(0);\n", first, "#if"},
           {"#ifdef MINE\n", first, "#if"},
           {"  const char* name = \"normal;\n", first, "this text is never closed"},
           {"  /* no end\n", first, "this comment is never closed"},
           {"  normal.apply(sum);\n", first, "nothing here has the name 'sum'"},
           {"  normal.impulze = 0;\n", first, "has nothing called 'impulze'"},
           {"  normal.aply(0);\n", first, "has nothing called 'aply'"},
           {"  normal.apply(normal.speed);\n", first, "it needs brackets ()"},
           {"  normal.apply(normal.impulse());\n", first, "is no function"},
           {"  normal.apply();\n", first, "too many, too few"},
           {"  normal.apply(1, 2);\n", first, "too many, too few"},
           {"  normal.apply(std::max(0, normal.impulse));\n", first, "write Real(0)"},
           {"  const Real sum = 0;\n  sum += normal.speed();\n", first + 1, "what is const cannot be changed"},
           {"  const Vec3 v = normal.speed() + Vec3::Zero();\n  normal.apply(v.x());\n", first, "do not go together"},
           {"  const Real sum = Vec3(1, 2, 3);\n  normal.apply(sum);\n", first,
            "a value of one kind stands where another"},
           {"  real sum = 0;\n  normal.apply(sum);\n", first, "nothing here has the name 'real'"},
           {"  if (normal.impulse > 0);\n    normal.apply(0);\n  else\n    normal.apply(1);\n", first + 2, "else"},
           {"  normal.speed() = 0;\n", first, "has to be a variable"},
           {"  normal->apply(0);\n", first, "a dot is needed"},
           {"  normal.impulse.x = 0;\n", first, "a plain number, and has no parts"},
           {"  normal.apply(normal.impulse ^ 2);\n", first, "x * x is a square"},
           {"  normal.apply(normal.impulse *);\n", first, "missing"},
           {"  Real sum = 0;\n  Real sum = 1;\n  normal.apply(sum);\n", first + 1, "declared twice"},
           {"  return normal.impulse;\n", first, "gives nothing back"},
           {"  const Real f = normal.apply(0);\n", first, "gives no value back"},
           {"  normal.apply(normal.impulse \xe2\x80\x93 1);\n", first, "a letter that C++ does not know"},
           {"  normal.apply(std::squareroot(2));\n", first, "std has nothing called 'squareroot'"},
           {"  auto f = [](Real x) { return x * normal.impulse; };\n  normal.apply(f(1));\n", first,
            "begin it with [&]"},
           {"  break;\n", first, "for loops"},
           {"  normal.impulse[0] = 1;\n", first, "is no list"},
           {"  const Mat3 m = Vec3::Zero();\n  normal.apply(m(0, 0));\n", first, "different shapes"},
       })
    says(filled_in(example(), broken.lines), broken);

  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = stub;
    REQUIRE(contains(text, from));
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string last_line = "inline const exercise_03::Answer answer{push_out};", end = "}  // namespace student",
                    unused = "(void)normal, (void)beta, (void)cap, (void)h;";
  says(replaced(last_line, ""), {"", last, "what your answer is"});
  says(replaced(last_line, last_line.substr(0, last_line.size() - 1)), {"", last - 2, "a semicolon is missing"});
  says(replaced(end, ""), {"", 6, "this { is never closed"});
  says(replaced(last_line + "\n\n" + end, "}\n" + last_line.substr(0, last_line.size() - 1)),
       {"", last - 1, "in braces { } that have ended"});
  says(replaced("#include \"pushback/chapters/03_baumgarte", "int nothing\n#include \"pushback/chapters/03_baumgarte"),
       {"", 4, "a semicolon or a } is missing"});
  says(replaced("#include \"pushback/chapters/03_baumgarte",
                "#include \"my.h\"\n#include \"pushback/chapters/03_baumgarte"),
       {"", 4, "there is no file my.h here"});
  says(replaced("namespace student", "Real helper(Real x);\nnamespace student"), {"", 6, "nothing here has the name"});
  says(replaced("inline void push_out", "Real helper(Real x);\n\ninline void push_out")
           .replace(replaced("inline void push_out", "Real helper(Real x);\n\ninline void push_out").find(unused),
                    unused.size(), "normal.apply(helper(1));"),
       {"", first - 1, "declared but never defined"});
  says(replaced("answer{push_out}", "answer{3}"), {"", last - 2, "a value of one kind"});
}

TEST_CASE("what g++ says and what clang++ says of the same slip has the same words") {
  for (const auto& [message, words] : std::vector<std::pair<std::string, std::string>>{
           {"expected ';' before 'row'", "a semicolon is missing"},
           {"expected ';' after expression", "a semicolon is missing"},
           {"expected ',' or ';' before 'row'", "a semicolon is missing"},
           {"expected ';' at end of declaration", "a semicolon is missing"},
           {"expected '}' at end of input", "each { needs one"},
           {"expected '}'", "each { needs one"},
           {"expected ')' before ';' token", "a closing bracket ) is missing"},
           {"expected ')'", "a closing bracket ) is missing"},
           {"expected '(' before 'row'", "an opening bracket ( is missing"},
           {"expected '(' after 'if'", "an opening bracket ( is missing"},
           {"expected primary-expression before ')' token", "a number or a name"},
           {"expected expression", "a number or a name"},
           {"'else' without a previous 'if'", "belongs to no if"},
           {"a function-definition is not allowed here before '{' token", "inside another one"},
           {"function definition is not allowed here", "inside another one"},
           {"expected declaration before '}' token", "too many or too few above"},
           {"extraneous closing brace ('}')", "too many or too few above"},
           {"expected unqualified-id before 'for'", "too many or too few above"},
           {"expected unqualified-id", "too many or too few above"},
           {"unterminated #if", "needs an #endif"},
           {"unterminated conditional directive", "needs an #endif"},
           {"unterminated comment", "needs a */"},
           {"unterminated /* comment", "needs a */"},
           {"missing terminating \" character", "a text is never closed"},
           {"stray '\\342' in program", "a letter that C++ does not know"},
           {"extended character \xe2\x80\x93 is not valid in an identifier", "a letter that C++ does not know"},
           {"unexpected character <U+2013>", "a letter that C++ does not know"},
           {"'sum' was not declared in this scope; did you mean 'sim'?", "nothing here has the name 'sum'"},
           {"use of undeclared identifier 'sum'; did you mean 'sim'?", "nothing here has the name 'sum'"},
           {"'real' does not name a type", "nothing here has the name 'real'"},
           {"unknown type name 'real'; did you mean 'Real'?", "nothing here has the name 'real'"},
           {"'using Row = struct pushback::ContactRow' has no member named 'x'", "has nothing called 'x'"},
           {"no member named 'x' in 'pushback::ContactRow'", "a pushback::ContactRow has nothing called 'x'"},
           {"'sqr' is not a member of 'std'; did you mean 'sqrt'?", "std has nothing called 'sqr'"},
           {"no member named 'sqr' in namespace 'std'; did you mean 'sqrt'?", "std has nothing called 'sqr'"},
           {"my.h: No such file or directory", "there is no file my.h here"},
           {"'my.h' file not found", "there is no file my.h here"},
           {"invalid use of non-static member function 'Real Row::speed() const'", "it needs brackets ()"},
           {"reference to non-static member function must be called; did you mean to call it with no arguments?",
            "it needs brackets ()"},
           {"'row.Row::impulse' cannot be used as a function", "is no function"},
           {"called object type 'double' is not a function or function pointer", "is no function"},
           {"lvalue required as left operand of assignment", "has to be a variable"},
           {"expression is not assignable", "has to be a variable"},
           {"assignment of read-only variable 'sum'", "what is const"},
           {"cannot assign to variable 'sum' with const-qualified type 'const Real'", "what is const"},
           {"passing 'const Row' as 'this' argument discards qualifiers [-fpermissive]", "what is const"},
           {"'this' argument to member function 'apply' has type 'const Row', but function is not marked const",
            "what is const"},
           {"no matching function for call to 'max(int, double)'", "write Real(0)"},
           {"no matching function for call to 'max'", "write Real(0)"},
           {"no matching function for call to 'student::Mine::f()'", "none that takes these values"},
           {"no matching member function for call to 'apply'", "none that takes these values"},
           {"too few arguments to function 'void f(double)'", "more values"},
           {"too few arguments to function call, expected 1, have 0", "more values"},
           {"too many arguments to function 'void f(double)'", "fewer values"},
           {"too many arguments to function call, expected 1, have 2", "fewer values"},
           {"base operand of '->' has non-pointer type 'Row'", "a dot is needed"},
           {"member reference type 'Row' is not a pointer; did you mean to use '.'?", "a dot is needed"},
           {"request for member 'x' in 'p', which is of pointer type 'Row*' (maybe you meant to use '->' ?)",
            "needs ->"},
           {"member reference type 'Row *' is a pointer; did you mean to use '->'?", "needs ->"},
           {"request for member 'x' in 'row.Row::impulse', which is of non-class type 'double'", "has no parts"},
           {"member reference base type 'double' is not a structure or union", "has no parts"},
           {"invalid types 'double[int]' for array subscript", "is no list"},
           {"subscripted value is not an array, pointer, or vector", "is no list"},
           {"invalid operands of types 'double' and 'int' to binary 'operator^'", "x * x is a square"},
           {"invalid operands to binary expression ('double' and 'int')", "x * x is a square"},
           {"no match for 'operator+' (operand types are 'double' and 'Vec3')", "do not go together"},
           {"invalid operands to binary expression ('Vec3' and 'double')", "do not go together"},
           {"static assertion failed: YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES", "different shapes"},
           {"static assertion failed due to requirement 'x': YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES",
            "different shapes"},
           {"return-statement with a value, in function returning 'void' [-fpermissive]", "gives nothing back"},
           {"void function 'solve' should not return a value", "gives nothing back"},
           {"return-statement with no value, in function returning 'double'", "does not"},
           {"non-void function 'f' should return a value", "does not"},
           {"void value not ignored as it ought to be", "gives no value back"},
           {"cannot initialize a variable of type 'const Real' (aka 'const double') with an rvalue of type 'void'",
            "gives no value back"},
           {"cannot convert 'Vec3' to 'Real' in initialization", "a value of one kind"},
           {"no viable conversion from 'Vec3' to 'const Real'", "a value of one kind"},
           {"narrowing conversion of 'x' from 'double' to 'int'", "lose its digits"},
           {"type 'double' cannot be narrowed to 'int' in initializer list", "lose its digits"},
           {"'row' declared as reference but not initialized", "at once"},
           {"declaration of reference variable 'row' requires an initializer", "at once"},
           {"redeclaration of 'Real sum'", "declared twice"},
           {"redefinition of 'sum'", "declared twice"},
           {"'row' is not captured", "[&]"},
           {"variable 'row' cannot be implicitly captured in a lambda with no capture-default specified", "[&]"},
           {"'Real Row::kept' is private within this context", "from outside"},
           {"'kept' is a private member of 'Row'", "from outside"},
           {"break statement not within loop or switch", "break is for loops"},
           {"'break' statement not in loop or switch statement", "break is for loops"},
           {"cannot bind non-const lvalue reference of type 'Row&' to an rvalue of type 'Row'", "needs a variable"},
           {"non-const lvalue reference to type 'Row' cannot bind to a temporary of type 'Row'", "needs a variable"},
           {"'answer' is not a member of 'student'", "the last line of the file is missing"},
           {"no member named 'answer' in namespace 'student'", "the last line of the file is missing"},
       }) {
    const std::string said = of_message(message);
    INFO(message << "\n" << said);
    CHECK(contains(said, "Line 1: \n\n    first line\n"));
    CHECK(contains(said, words));
    CHECK(contains(said, " (The compiler: " + message + ".)"));
  }
  CHECK(contains(of_message("something new"), "Line 1: "));
  CHECK(contains(of_message("something new"), "the compiler says: something new."));
}

TEST_CASE("an error that shows in a header has the line of the student's file from which it comes") {
  const ScratchFolder folder;
  const fs::path file = folder.path / "02.h";
  write_text_file(
      file, "#include <cmath>\nint nothing  // to be ended\n\n#include \"other.h\"\nauto m = sum(a, b);\nanswer\n");
  const std::string to_file = "/tmp/x/02.h:";
  for (const auto& [messages, line] : std::vector<std::pair<std::string, std::string>>{
           {"In file included from " + to_file +
                "4,\n                 from <command-line>:\n/usr/include/other.h:3:1: error: "
                "expected initializer before 'namespace'\n",
            "2"},
           {"In file included from <built-in>:1:\nIn file included from " + to_file +
                "4:\n/usr/include/other.h:3:1: error: expected "
                "';' after top level declarator\n",
            "2"},
           {"/usr/include/other.h: In instantiation of 'x':\n" + to_file +
                "5:9:   required from here\n/usr/include/other.h:9:9: "
                "error: static assertion failed: YOU_MIXED\n",
            "5"},
           {"/usr/include/other.h:9:9: error: static_assert failed \"YOU_MIXED\"\n" + to_file +
                "5:9: note: in instantiation of function template specialization 'x' requested here\n",
            "5"},
           {"/usr/exercise/answer.cpp:2:1: error: no matching function for call to 'play(x)'\n", "6"},
       }) {
    const std::string said = first_error(messages, file);
    INFO(messages << said);
    CHECK(contains(said, "Line " + line + ": "));
  }
  CHECK(
      contains(first_error("/usr/bin/ld: answer.o: in function `f()':\nanswer.cpp:(.text+0x1): undefined reference to "
                           "`student::sum(double, double)'\n",
                           file),
               "Line 5: "));
}

TEST_CASE("the bracket that was forgotten is found by the indentation, past comments, quotes and other numbers") {
  const auto found = [](const std::string& text) {
    const std::optional<Unclosed> one = unclosed(text);
    return one ? fmt::format("{}: {}", one->line, one->words.substr(0, one->words.find(':'))) : "";
  };
  CHECK(found("void f() {\n  g(')', \"({[\", 1'000, '\\'', \"\\\"\");  // ({[\n  /* { */\n  for (int i = 0; i < 1; "
              "++i) {}\n}\n")
            .empty());
  CHECK(found("#if A\n  # if B\n#endif\n#endif\n").empty());
  CHECK(found("void f() {\n  if (a) {\n    g();\n}\nvoid h() {\n}\n") == "2: this { is never closed");
  CHECK(found("void f() {\n  if (a) {\n    g();\n  }\n") == "1: this { is never closed");
  CHECK(found("void f() {\n  g();\n  }\n}\n") == "3: this } closes nothing");
  CHECK(found("void f() {\n  g(a[1);\n}\n") == "2: this [ is never closed");
  CHECK(found("void f() {\n  g((1);\n}\n") == "2: this ( is never closed");
  CHECK(found("void f() {\n  h([&] { g(1; });\n}\n") == "2: this ( is never closed");
  CHECK(found("a\n/* b") == "2: this comment is never closed");
  CHECK(found("a = \"b;\n") == "1: this text is never closed");
  CHECK(found("#endif\n") == "1: this #endif has no #if above.");
}
