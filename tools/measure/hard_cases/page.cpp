/// What the book plays where a cell of the table of hard cases is opened.
#include "pushback/tools/measure/hard_cases/described.h"

int main(int argc, char** argv) {
  pushback::Experiment e("hard_cases", "Which stage keeps which case stable?");
  return e.run(argc, argv, [&] { pushback::describe_hard_cases(e); });
}
