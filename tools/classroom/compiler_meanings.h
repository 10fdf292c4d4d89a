/// The most common errors of g++ and clang++, in plain words.
#pragma once

#include <string>

namespace pushback {

/// What an error means that a compiler words like this, without its place; empty: it is not known here.
std::string meaning_of(const std::string& error);

}  // namespace pushback
