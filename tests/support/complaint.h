/// What is said of input that cannot be used.
#pragma once

#include <functional>
#include <string>

#include "pushback/common/basics/input.h"

namespace pushback {

/// What `act` throws, or "" if it throws nothing.
inline std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace pushback
