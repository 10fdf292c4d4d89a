/// Who is held against whom on frozen problems.
#pragma once

#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/tools/measure/frozen/siconos.h"

namespace pushback::frozen {

/// Those of chapters 16 and 17, then those of Siconos where it is built in.
inline std::vector<std::string> frozen_methods() {
  std::vector<std::string> names = method_names();
  for (const std::string& name : siconos_methods()) names.push_back(name);
  return names;
}

inline bool is_siconos(const std::string& method) {
  return method.starts_with("Siconos ");
}

}  // namespace pushback::frozen
