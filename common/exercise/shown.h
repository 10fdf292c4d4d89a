/// The bodies of a check's scene, for the picture beside a verdict. Nothing of this is taken for the verdict.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// Called in a check's `play`: bodies and contacts as they are now are an instant that the picture may show. `quantities`:
/// those of the check's that are measured on this world, where a scene has several worlds.
void show(const World& world, const std::vector<std::size_t>& quantities = {});

struct Instant {
  std::size_t number;                   ///< of the scene's, from 0 on
  std::vector<std::size_t> quantities;  ///< empty: all
  World world;                          ///< bodies, contacts, joints and time
};

inline constexpr std::size_t most_instants = 16;

/// While it lives, it keeps what this thread shows: the last instant, and of the others every second, every fourth, ... so
/// that `most_instants` are enough.
class Recording {
 public:
  Recording();
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  const std::vector<Instant>& instants() const { return instants_; }

 private:
  friend void show(const World& world, const std::vector<std::size_t>& quantities);
  void keep(const World& world, const std::vector<std::size_t>& quantities);
  std::vector<Instant> instants_;
  std::size_t shown_ = 0, stride_ = 1;
  Recording* outer_;
};

/// What a student's program says of an instant: its number, of each body position (m), orientation (x, y, z, w) and the two
/// velocities, whether it sleeps (1, or 0), and of each contact point, normal, impulse (N s), bodies and state. What does not
/// move, shapes and joints are known.
Numbers numbers_of(const Instant& instant);
/// Back again: `right`, with bodies and contacts where `numbers` says. Nothing where these are not of as many bodies, of more
/// than `most_contacts`, or where one is not finite, or beyond all reach.
std::optional<World> with_numbers(World right, const Numbers& numbers);

inline constexpr std::size_t most_contacts = 256;
/// A longer list is no instant.
inline constexpr std::size_t most_numbers_shown = 6000;

}  // namespace pushback
