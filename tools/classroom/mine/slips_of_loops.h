/// Known mistakes of chapters: each is the chapter's plain loop with a few lines replaced, see slips/NN.txt. A
/// build makes code of them.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/exercise/whole_solver.h"

namespace pushback {

struct SlipOfLoop {
  std::string name, hint;
  WholeSolver solver;
};

/// Empty for a chapter that has no such file.
const std::vector<SlipOfLoop>& slips_of_loop(int chapter);

std::vector<SlipOfLoop> slips_of_loop_00();
std::vector<SlipOfLoop> slips_of_loop_01();
std::vector<SlipOfLoop> slips_of_loop_02();
std::vector<SlipOfLoop> slips_of_loop_03();
std::vector<SlipOfLoop> slips_of_loop_05();
std::vector<SlipOfLoop> slips_of_loop_06();
std::vector<SlipOfLoop> slips_of_loop_07();
std::vector<SlipOfLoop> slips_of_loop_08();
std::vector<SlipOfLoop> slips_of_loop_09();
std::vector<SlipOfLoop> slips_of_loop_10();
std::vector<SlipOfLoop> slips_of_loop_11();
std::vector<SlipOfLoop> slips_of_loop_12();
std::vector<SlipOfLoop> slips_of_loop_13();
std::vector<SlipOfLoop> slips_of_loop_14();
std::vector<SlipOfLoop> slips_of_loop_21();

}  // namespace pushback
