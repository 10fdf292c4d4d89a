#include "pushback/common/experiment/legend.h"

#include "pushback/common/render/palette.h"

namespace pushback {

void Legend::see(const Picture& picture) {
  for (const Dot& dot : picture.dots) {
    for (const ContactState state :
         {ContactState::fresh, ContactState::warm, ContactState::sliding, ContactState::sticking}) {
      if (dot.colour == contact_colour(state)) dots_.insert(state);
    }
  }
  for (const Arrow& arrow : picture.arrows) {
    normal_arrows_ = normal_arrows_ || arrow.colour == normal_arrow_colour();
    friction_arrows_ = friction_arrows_ || arrow.colour == friction_arrow_colour();
  }
  for (const Solid& solid : picture.solids) sleepers_ = sleepers_ || solid.colour == asleep_colour();
}

void Legend::add(const Legend& other) {
  dots_.insert(other.dots_.begin(), other.dots_.end());
  normal_arrows_ = normal_arrows_ || other.normal_arrows_;
  friction_arrows_ = friction_arrows_ || other.friction_arrows_;
  sleepers_ = sleepers_ || other.sleepers_;
}

std::vector<LegendEntry> Legend::entries() const {
  using Kind = LegendEntry::Kind;
  std::vector<LegendEntry> all;
  const auto add = [&](ContactState state, const std::string& text) {
    if (dots_.contains(state)) all.push_back({Kind::dot, contact_ink(state), text});
  };
  const bool friction = dots_.contains(ContactState::sticking) || dots_.contains(ContactState::sliding);
  add(ContactState::fresh, dots_.contains(ContactState::warm) ? "new contact"
                           : friction                         ? "contact: new, or without friction"
                                                              : "contact");
  add(ContactState::warm, "contact kept from the step before");
  add(ContactState::sticking, "friction below its limit");
  add(ContactState::sliding, "friction at its limit");
  if (normal_arrows_) all.push_back({Kind::arrow, normal_arrow_ink(), "normal impulse"});
  if (friction_arrows_) all.push_back({Kind::arrow, friction_arrow_ink(), "friction impulse"});
  if (sleepers_) all.push_back({Kind::body, asleep_ink(), "asleep"});
  return all;
}

}  // namespace pushback
