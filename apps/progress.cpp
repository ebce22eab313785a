// SPDX-License-Identifier: MIT
#include "progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "resources.h"

namespace penumbra {
namespace {

constexpr const char* clear_line = "\r\x1b[K";

int terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string clock_text(double seconds) {
  const long long whole = std::llround(std::clamp(seconds, 0.0, 3.6e8));
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string bar_text(const std::string& label, double share, const std::string& time_left,
                     int columns) {
  const std::string head = label + " ",
                    tail = fmt::format(" {:3.0f} %  {}", 100 * share, time_left);
  const int room = columns - 1 - static_cast<int>(head.size() + tail.size()) - 2;
  if (room < 5) return tail.substr(1, static_cast<std::size_t>(std::max(0, columns - 1)));
  const int width = std::min(room, 40);
  const int filled = static_cast<int>(share * width);
  return head + "[" + std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(width - filled), '.') + "]" + tail;
}

Progress::Progress(std::string label, ProgressWish wish)
    : label_(std::move(label)), start_(now_seconds()), last_drawn_(start_) {
  if (::isatty(STDERR_FILENO))
    style_ = Style::bar;
  else if (wish == ProgressWish::always)
    style_ = Style::lines;
}

Progress::~Progress() {
  if (is_drawn_) std::fputs(clear_line, stderr);
}

void Progress::update(double share) {
  if (style_ == Style::none) return;
  share = std::clamp(share, 0.0, 1.0);
  const double now = now_seconds(), elapsed = now - start_;
  // The first moments say nothing about the whole.
  const bool can_tell = share > 0.01 && elapsed > 0.5;
  const std::string time_left =
      can_tell ? clock_text(elapsed / share * (1 - share)) + " left" : std::string();
  if (style_ == Style::bar) {
    if (is_drawn_ && now - last_drawn_ < 0.1) return;
    last_drawn_ = now;
    draw(bar_text(label_, share, time_left, terminal_columns()));
  } else if (const int tenths = static_cast<int>(share * 10);
             tenths > tenths_ && (tenths == 10 || now - last_drawn_ >= 1)) {
    tenths_ = tenths;
    last_drawn_ = now;
    fmt::print(stderr, "{} {} %{}\n", label_, 10 * tenths,
               can_tell && tenths < 10 ? ", " + time_left : "");
  }
}

void Progress::update(const std::string& done) {
  const double now = now_seconds();
  if (style_ == Style::none || now - last_drawn_ < (style_ == Style::bar ? 0.1 : 1)) return;
  last_drawn_ = now;
  if (style_ == Style::bar)
    draw(label_ + " " + done);
  else
    fmt::print(stderr, "{} {}\n", label_, done);
}

void Progress::draw(const std::string& text) {
  is_drawn_ = true;
  fmt::print(stderr, "{}{}", clear_line, text);
  std::fflush(stderr);
}

}  // namespace penumbra
