/// One run of a scene by one solver, as the program mine_lap prints it.
#pragma once

#include <optional>
#include <string>

namespace pushback {

inline constexpr int lap_steps = 300;  ///< of 1/60 s
inline constexpr const char* plain_name = "plain loop of 08";
inline constexpr const char* recommended_name = "21 detected once";

struct Lap {
  double ms_per_step = 0;    ///< this thread's own time, detection included
  double overlap = 0;        ///< mm, the deepest in any step
  double moved = 0;          ///< mm, from its start, of the body that is farthest from it at the end
  double speed = 0;          ///< mm/s, of the fastest body at the end
  double energy_gained = 0;  ///< J, the most above the energy of the start in any step
};

/// The last line of what the program printed, with all digits; nothing where it is none.
std::string line_of(const Lap& lap);
std::optional<Lap> read_lap(const std::string& printed);

}  // namespace pushback
