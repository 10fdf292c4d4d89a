/// Contact problems to hold methods against: one step each, taken out of our scenes, and files of others.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback::frozen {

struct FrozenProblem {
  std::string name;  ///< a few words, no comma
  ContactProblem problem;
  SparseMatrix factor = {};  ///< B with W = B B^T, where the bodies are known
  bool foreign = false;      ///< of a file, not of a scene of ours
};

/// The contacts of scenes as a step of 1/60 s begins, with nothing remembered: some as they are built, some after they
/// have come to rest or into trouble, by the solver of chapter 12. Always the same, in the same bits.
std::vector<FrozenProblem> own_problems();

/// Pyramids and heaps of 283 to 3,866 contacts, made alike; the largest takes half a minute.
std::vector<FrozenProblem> large_problems();
inline constexpr int large_contacts = 400;  ///< of others: from so many contacts on, they are put beside those

/// Every .dat file of the folder, by name. Throws InvalidInput where there is no such folder, none in it, or a bad one.
std::vector<FrozenProblem> foreign_problems(const std::filesystem::path& folder);

}  // namespace pushback::frozen
