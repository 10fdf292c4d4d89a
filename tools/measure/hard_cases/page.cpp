/// What the book plays where a cell of the table of hard cases is opened.
#include "pushback/common/experiment/experiment.h"
#include "pushback/tools/measure/hard_cases/table.h"

int main(int argc, char** argv) {
  pushback::Experiment e("hard_cases", "Which stage keeps which case stable?");
  return e.run(argc, argv, [&] { pushback::describe_hard_cases(e); });
}
