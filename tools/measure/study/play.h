/// A solver of ours or another engine plays a motion: how far from the truth it comes, and how long it takes.
#pragma once

#include <memory>
#include <optional>

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback {

/// The knobs. A substep is 1 / (60 substeps) s, so this is the time step and the number of substeps in one.
struct Setting {
  int substeps = 1;  ///< in a frame of 1/60 s
  int sweeps = 10;   ///< or iterations, in each substep

  double dt() const { return 1.0 / (frames_per_second * substeps); }
};

/// A solver of ours or another engine, with a world in it.
class Player {
 public:
  virtual ~Player() = default;
  /// So many steps of h, s. Throws InvalidInput if it gives up.
  virtual void steps(int count, double h) = 0;
  /// The position, orientation and velocities of a movable body.
  virtual void get(Body& body) const = 0;
  /// In all steps so far; nothing where an engine does not say, or solves linear systems, and rows are no measure.
  virtual std::optional<double> row_solves() const { return {}; }
  /// Of its own clock, in all steps so far; nothing where ours is right. One that is asked through a pipe has its own.
  virtual std::optional<double> seconds() const { return {}; }
};

inline bool plays_all(const Motion&) {
  return true;
}

/// One way to play motions.
struct Method {
  std::string name;                                      ///< a word for the command line
  std::string title;                                     ///< a few words for a diagram
  std::function<bool(const Motion&)> plays = plays_all;  ///< whether the motion is something for it
  std::function<std::unique_ptr<Player>(const World&, const Setting&)> begin;
  bool sweeps = true;    ///< whether the number of sweeps is a knob of it
  bool divides = false;  ///< a frame of 1/60 s is one step, which it divides itself; else a substep is one
};

/// A motion under a method, frame by frame.
class MotionRun {
 public:
  MotionRun(const Motion& motion, const Method& method, const Setting& setting);
  void frame() { player_->steps(count_, h_); }  ///< 1/60 s
  Places places() const;                        ///< m, of all bodies, now
  const Player& player() const { return *player_; }

 private:
  World begin_;
  std::unique_ptr<Player> player_;
  int count_;  // of steps in a frame
  double h_;   // s
};

struct Patience {
  double at_least = 0.01;  ///< s: it is played again until it has taken so long
  double at_most = 60;     ///< s: after which it is given up; looked at after each frame
};

/// Plays the motion, once in any case. Only substeps are in the time: not the making of a world, not asking where bodies
/// are (for which MuJoCo has kinematics to do), and not the comparing. The error is the farthest that any body was from its true place
/// in any frame; the time is the median of some times that it was played. `truth`: motion.truth(motion.frames()).
study::Measured play(const Motion& motion, const std::vector<Places>& truth, const Method& method,
                     const Setting& setting, const Patience& patience = {});

/// The program  NAME MOTION METHOD/SMALL-STEPS/SWEEPS ...  plays the motion in each of these settings and prints a line for each, as
/// line_of has it. It is "lost" where a body was more than 10 km off, and "late" where it was given up, or not begun, as it asks for no
/// less of either knob than one before it that was given up. Without a motion it lists the motions that there are, with one its
/// methods; with --version it says which engine plays: `version`. Returns the exit status: 0; 2 where a value cannot be used, and then
/// nothing was played.
int play_program(int argc, const char* const* argv, const std::string& about, const std::string& version,
                 const std::vector<Method>& methods);

}  // namespace pushback

// ---- a Measured as text: the line that a program prints, and the words that stand for missing numbers ----

namespace pushback::study {

/// m, or "late" or "lost".
std::string error_text(const Measured& one);
/// "–" where rows are no measure.
std::string row_solves_text(const Measured& one);
/// Both back again. Throws InvalidInput where a word is none of these.
void read_error(const std::string& word, Measured& into);
void read_row_solves(const std::string& word, Measured& into);

/// "full/4/16 error 1.2345e-03 seconds 4.5678e-02 row-solves 6.7890e+06", of what was played once.
std::string line_of(const Measured& once);
/// Adds to a setting what such a line says of it. Throws std::runtime_error, with the engine and the line, where it is none.
void add_line(const std::string& line, Measured& into);

}  // namespace pushback::study
