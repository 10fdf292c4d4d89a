#include "pushback/tools/classroom/mine/slips_of_loops.h"

#include <map>

namespace pushback {

const std::vector<SlipOfLoop>& slips_of_loop(int chapter) {
  static const std::map<int, std::vector<SlipOfLoop>> all{
      {0, slips_of_loop_00()},  {1, slips_of_loop_01()},  {2, slips_of_loop_02()},  {3, slips_of_loop_03()},
      {5, slips_of_loop_05()},  {6, slips_of_loop_06()},  {7, slips_of_loop_07()},  {8, slips_of_loop_08()},
      {9, slips_of_loop_09()},  {10, slips_of_loop_10()}, {11, slips_of_loop_11()}, {12, slips_of_loop_12()},
      {13, slips_of_loop_13()}, {14, slips_of_loop_14()}, {21, slips_of_loop_21()}};
  static const std::vector<SlipOfLoop> none;
  const auto found = all.find(chapter);
  return found == all.end() ? none : found->second;
}

}  // namespace pushback
