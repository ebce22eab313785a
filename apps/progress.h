// SPDX-License-Identifier: MIT
// How far a long task is, on stderr: a bar with the time left on a terminal, lines elsewhere.
#pragma once

#include <string>

namespace penumbra {

enum class ProgressWish { on_terminal, always };

class Progress {
 public:
  /// Shows nothing yet. `on_terminal`: nothing at all unless stderr is one.
  Progress(std::string label, ProgressWish wish);
  /// Leaves the terminal's line empty, for what is printed next.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The finished share in [0, 1]; one call at a time. Cheap: draws at most ten times a second.
  void update(double share);
  /// Where the end is not known: `done` says how far, as in "2000000 points".
  void update(const std::string& done);

 private:
  enum class Style { none, bar, lines };

  void draw(const std::string& text);

  std::string label_;
  Style style_ = Style::none;
  double start_ = 0, last_drawn_ = 0;
  int tenths_ = 0;         // of them printed as lines
  bool is_drawn_ = false;  // a bar is on the terminal
};

/// "0:07", "12:30", "1:02:05"
std::string clock_text(double seconds);

/// `label [####....]  45 %  0:12 left`, at most `columns` - 1 wide, so that the cursor stays on the
/// line.
std::string bar_text(const std::string& label, double share, const std::string& time_left,
                     int columns);

}  // namespace penumbra
