/// All colours, as Ink for legends and text and as linear Colour for the painter.
///
/// They were chosen by simulating colour blindness. Any two contact states, any state and any body, and the two kinds of arrow stay
/// clearly distinguishable (CIE76 distance above 19). A test asserts this. The colours of bodies are muted, so that contacts and
/// impulses stand out.
#pragma once

#include <array>

#include "pushback/common/collision/contact.h"
#include "pushback/common/render/canvas.h"
#include "pushback/common/render/light.h"
#include "pushback/common/render/picture.h"

namespace pushback {

inline Colour linear(Ink ink) {
  return {linear_of(ink.red), linear_of(ink.green), linear_of(ink.blue)};
}

/// Blue, teal, mustard, orange, brick, olive. Any index is allowed, because the colours repeat.
inline Ink body_ink(int index) {
  constexpr std::array<Ink, 6> inks = {
      {{31, 80, 137}, {18, 138, 120}, {214, 176, 74}, {207, 106, 38}, {156, 47, 42}, {127, 154, 85}}};
  constexpr int count = static_cast<int>(inks.size());
  return inks[static_cast<std::size_t>((index % count + count) % count)];
}
inline Ink near_black_ink() {
  return {28, 32, 42};
}
/// For sleeping bodies, instead of their own colours.
inline Ink asleep_ink() {
  return {84, 88, 100};
}
/// For bodies that cannot move.
inline Ink fixed_ink() {
  return {188, 192, 198};
}

inline Ink contact_ink(ContactState state) {
  switch (state) {
    case ContactState::fresh:
      return {255, 255, 255};
    case ContactState::warm:
      return {255, 230, 0};
    case ContactState::sliding:
      return {255, 47, 208};
    case ContactState::sticking:
      return {21, 24, 43};
  }
  return near_black_ink();
}

inline Ink normal_arrow_ink() {
  return {0, 168, 245};
}
inline Ink friction_arrow_ink() {
  return {122, 46, 230};
}

/// For a quantity that a reader points at: book.css has the same colour.
inline Ink lit_ink() {
  return {255, 0, 140};
}

inline Colour body_colour(int index) {
  return linear(body_ink(index));
}
inline Colour near_black_colour() {
  return linear(near_black_ink());
}
inline Colour asleep_colour() {
  return linear(asleep_ink());
}
inline Colour fixed_colour() {
  return linear(fixed_ink());
}
inline Colour contact_colour(ContactState state) {
  return linear(contact_ink(state));
}
inline Colour normal_arrow_colour() {
  return linear(normal_arrow_ink());
}
inline Colour friction_arrow_colour() {
  return linear(friction_arrow_ink());
}
inline Colour lit_colour() {
  return linear(lit_ink());
}

}  // namespace pushback
