/// What the programs that play a table of hard cases have in common.
#pragma once

#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

/// Which columns a table has, and what is made of it.
struct TableKind {
  std::string folder = "hard_cases";  ///< in that of --out
  std::string file = "table";         ///< the names of its CSV file and its page
  std::string times = "times.csv";    ///< milliseconds of a step: the only file that differs from run to run
  std::string picture = "overview";   ///< the name of its picture; empty: it has none
  std::vector<Stage> stages = {};     ///< the columns to choose from
  std::vector<Stage> further = {};    ///< columns after the chosen ones
  bool whole = true;                  ///< else its files go to part/, whatever is chosen
  GivingUp giving_up = {};            ///< of a stage that is played apart
  std::function<std::string(const Table&, const std::filesystem::path& folder)> page = table_md;
  std::function<Table(const Table&)> shown = [](const Table& table) {
    return table;
  };  ///< on the page and in the picture
};

/// Adds the common options to the line, reads it, and plays, joins or shows the table. `kind_of` is called after the options were read.
/// Returns the exit status: 1 if a stage that is played apart crashed, threw or came to no end.
int table_program(int argc, const char* const* argv, CommandLine& line, const std::function<TableKind()>& kind_of);

}  // namespace pushback
