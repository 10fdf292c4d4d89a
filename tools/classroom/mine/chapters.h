/// The requirements of `./course mine NN` on a whole solver, as one exercise: checks of this chapter and of all it grows from.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/mine/scenes.h"

namespace pushback {

/// A chapter that a solver of one's own grows by.
struct ChapterOfMine {
  int number;
  std::string title;               ///< "one row a contact, over and over"
  std::vector<std::string> hints;  ///< one more at each --hint
};

const std::vector<ChapterOfMine>& chapters_of_mine();
/// 03, 3, baumgarte, 03_baumgarte. Throws InvalidInput, naming all there are.
const ChapterOfMine& chapter_of_mine(std::string_view word);
/// 03
std::string two_digits(int chapter);
/// 03_baumgarte: its folder in chapters/, and its program.
std::string folder_of(int chapter);

/// Checks that ended with an earlier chapter (see scenes.h) are among them, with tolerances that nothing exceeds: the numbers
/// by which checks go are the same in every chapter.
Exercise exercise_of_chapter(int chapter);
/// The chapter that a check of such an exercise belongs to.
int chapter_of_check(std::size_t check);
/// Whether `earlier` is `chapter`, or one that it grew from.
bool grows_from(int chapter, int earlier);
/// Whether a right solver of this chapter passes it, as the chapter grows from the check's.
bool holds(std::size_t check, int chapter);

const WholeSolver& plain_solver(int chapter);
/// The chapter's plain loop, flat.h and flat.cpp, as one file like the reader's own: its class is MySolver.
std::string plain_loop(int chapter);

}  // namespace pushback
