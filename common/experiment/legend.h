/// Explains the dots, arrows and colours that occur in pictures.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "pushback/common/collision/contact.h"
#include "pushback/common/render/canvas.h"
#include "pushback/common/render/picture.h"

namespace pushback {

struct LegendEntry {
  enum class Kind { dot, arrow, body };

  Kind kind;
  Ink colour;
  std::string text;
};

class Legend {
 public:
  void see(const Picture& picture);
  void add(const Legend& other);
  /// The entries for all marks seen.
  std::vector<LegendEntry> entries() const;

 private:
  std::set<ContactState> dots_;
  bool normal_arrows_ = false, friction_arrows_ = false, sleepers_ = false;
};

}  // namespace pushback
