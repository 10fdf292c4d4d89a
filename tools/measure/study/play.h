/// Plays a motion with one of our solvers or another engine, and measures its error and its time.
#pragma once

#include <memory>
#include <optional>

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback {

/// A setting of a method. A substep is 1 / (60 substeps) s, so `substeps` is both the number per frame and the time step.
struct Setting {
  int substeps = 1;  ///< in a frame of 1/60 s
  int sweeps = 10;   ///< or iterations, in each substep

  double dt() const { return 1.0 / (frames_per_second * substeps); }
};

/// One of our solvers or another engine, with a world.
class Player {
 public:
  virtual ~Player() = default;
  /// Takes `count` steps of h, s. Throws InvalidInput if it fails.
  virtual void steps(int count, double h) = 0;
  /// Sets the position, orientation and velocities of a movable body from the player's.
  virtual void get(Body& body) const = 0;
  /// The row solves in all steps so far, or none if an engine does not report them, or solves linear systems, so that rows do not measure
  /// its work.
  virtual std::optional<double> row_solves() const { return {}; }
  /// The time of all steps so far by the player's own clock, s, or none if our clock is right. An adapter behind a pipe has its own clock.
  virtual std::optional<double> seconds() const { return {}; }
};

inline bool plays_all(const Motion&) {
  return true;
}

/// One way to play motions.
struct Method {
  std::string name;                                      ///< a word for the command line
  std::string title;                                     ///< a few words for a diagram
  std::function<bool(const Motion&)> plays = plays_all;  ///< whether the method can play a motion
  std::function<std::unique_ptr<Player>(const World&, const Setting&)> begin;
  bool sweeps = true;    ///< whether it has a number of sweeps
  bool divides = false;  ///< whether a frame of 1/60 s is one step, which it divides itself, or each substep is one
};

/// Plays a motion with a method, frame by frame.
class MotionRun {
 public:
  MotionRun(const Motion& motion, const Method& method, const Setting& setting);
  void frame() { player_->steps(count_, h_); }  ///< 1/60 s
  Places places() const;                        ///< m, of all bodies, now
  const Player& player() const { return *player_; }

 private:
  World begin_;
  std::unique_ptr<Player> player_;
  int count_;  // number of steps in a frame
  double h_;   // s
};

struct Patience {
  double at_least = 0.01;  ///< s; the motion is repeated until it has taken this long
  double at_most = 60;     ///< s, after which it is given up, tested after each frame
};

/// Plays the motion at least once. The time includes only the substeps, not the setup of the world, the query of positions (for which
/// MuJoCo computes kinematics) and the comparison. The error is the largest distance of a body from its true position in any frame.
/// The time is the median over the repetitions. `truth`: motion.truth(motion.frames()).
study::Measured play(const Motion& motion, const std::vector<Places>& truth, const Method& method,
                     const Setting& setting, const Patience& patience = {});

/// The program  NAME MOTION METHOD/SMALL-STEPS/SWEEPS ...  plays the motion in each of these settings and prints a line of line_of for
/// each. A setting is "lost" if a body was more than 10 km off. It is "late" if it was given up, or not begun because an earlier setting
/// with no more substeps and no more sweeps was given up. Without a motion the program lists all motions, and with a motion but no
/// setting its methods. With --version it prints `version`, which names the engine. Returns the exit status, which is 0, or 2 if a
/// value cannot be used, before anything is played.
int play_program(int argc, const char* const* argv, const std::string& about, const std::string& version,
                 const std::vector<Method>& methods);

}  // namespace pushback

// ---- a Measured as text, with the line that a program prints, and the words for missing numbers ----

namespace pushback::study {

/// The error in m, or "late" or "lost".
std::string error_text(const Measured& one);
/// The number of row solves, or "–" if there is none.
std::string row_solves_text(const Measured& one);
/// Each reads one of these texts. Throws InvalidInput if a word has neither form.
void read_error(const std::string& word, Measured& into);
void read_row_solves(const std::string& word, Measured& into);

/// The line "full/4/16 error 1.2345e-03 seconds 4.5678e-02 row-solves 6.7890e+06" for a setting that was played once.
std::string line_of(const Measured& once);
/// Adds the values of such a line to a setting. Throws std::runtime_error, with the engine and the line, if it has another format.
void add_line(const std::string& line, Measured& into);

}  // namespace pushback::study
