// SPDX-License-Identifier: MIT
#include "penumbra/scene/error.h"

#include <fmt/format.h>

namespace penumbra {

Error::Error(Place where, std::string what, std::string hint_)
    : std::runtime_error(message(where, what, hint_)),
      place(std::move(where)),
      problem(std::move(what)),
      hint(std::move(hint_)) {}

std::string message(const Error::Place& place, const std::string& problem,
                    const std::string& hint) {
  std::string text = place.file;
  if (place.line) text += fmt::format(":{}", *place.line);
  if (!text.empty()) text += ": ";
  if (place.byte) text += fmt::format("byte {}: ", *place.byte);
  text += problem;
  if (!hint.empty()) text += "; " + hint;
  return text;
}

}  // namespace penumbra
