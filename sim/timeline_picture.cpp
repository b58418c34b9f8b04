// SPDX-License-Identifier: MIT
#include "sim/timeline_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cigsim {
namespace {

constexpr std::size_t kMostPictures = 4;
constexpr double kLeft = 170, kRight = 24, kTop = 56, kWidth = 1000;
constexpr double kRow = 34, kBar = 22, kAxis = 46;
constexpr double kShortestLabel = 58;  // width of a bar that still holds its label

constexpr const char* kColours[] = {"#2f6fab", "#d1782c", "#3c8f5a", "#8b5fa8"};

// Pictures on a time axis from the first input to the last element.
class Timeline {
 public:
  Timeline(const std::vector<FrameTiming>& pictures, double clock_ns)
      : pictures_(pictures.begin(), pictures.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                           pictures.size(), kMostPictures))),
        clock_ns_(clock_ns),
        begin_(pictures_.front().input),
        end_(pictures_.back().last_element + 1) {}

  std::string svg() {
    const double height = kTop + kStageCount * kRow + kAxis;
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        kWidth, height);
    frame_starts();
    for (std::size_t s = 0; s < kStageCount; ++s) row(s);
    delay();
    axis();
    return text_ + "</svg>\n";
  }

 private:
  double x(Cycle cycle) const {
    return kLeft + (kWidth - kLeft - kRight) * static_cast<double>(cycle - begin_) /
                       static_cast<double>(end_ - begin_);
  }
  double milliseconds(Cycle cycles) const { return static_cast<double>(cycles) * clock_ns_ * 1e-6; }

  void frame_starts() {
    const auto mark = [&](Cycle cycle) {
      text_ += fmt::format(
          "<line x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\" stroke=\"#b8b8b8\" "
          "stroke-dasharray=\"3 3\"/>\n",
          x(cycle), kTop - 6, kTop + kStageCount * kRow);
    };
    for (const FrameTiming& picture : pictures_) mark(picture.input);
    const FrameTiming& last = pictures_.back();
    mark(last.input + last.period[0]);
    mark(last.input + last.period[0] + last.period[1]);
  }

  void row(std::size_t stage) {
    const double y = kTop + static_cast<double>(stage) * kRow;
    text_ += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", kLeft - 10,
                         y + kBar / 2 + 4, name_of(kAllStages[stage]));
    for (std::size_t p = 0; p < pictures_.size(); ++p) {
      const Activity& a = pictures_[p].activity[stage];
      const double from = x(a.start), width = std::max(1.0, x(a.finish + 1) - from);
      text_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" rx=\"2\" "
          "fill=\"{}\"><title>picture {}: cycles {} to {}; {} busy, {} idle, {} stalled</title>"
          "</rect>\n",
          from, y, width, kBar, kColours[p % std::size(kColours)], p, a.start, a.finish, a.busy(),
          a.idle, a.stalled);
      if (width >= kShortestLabel)
        text_ += fmt::format(
            "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"#ffffff\" text-anchor=\"middle\">picture {}"
            "</text>\n",
            from + width / 2, y + kBar / 2 + 4, p);
    }
  }

  // An arrow over the rows, from the first picture's input to its last element.
  void delay() {
    const FrameTiming& first = pictures_.front();
    const double from = x(first.input), to = x(first.last_element + 1), y = kTop - 18;
    text_ += fmt::format(
        "<path d=\"M{0:.1f} {2} L{1:.1f} {2} M{3:.1f} {4} L{1:.1f} {2} L{3:.1f} {5} M{0:.1f} {4} "
        "L{0:.1f} {5}\" fill=\"none\" stroke=\"#333333\"/>\n"
        "<text x=\"{6:.1f}\" y=\"{7}\" text-anchor=\"middle\">transport delay of picture 0: {8} "
        "cycles, {9:.1f} ms</text>\n",
        from, to, y, to - 6, y - 4, y + 4, (from + to) / 2, y - 8, first.transport_delay(),
        milliseconds(first.transport_delay()));
  }

  void axis() {
    const double y = kTop + kStageCount * kRow + 4;
    const double whole = milliseconds(end_ - begin_);
    const double step = std::pow(10, std::floor(std::log10(whole / 4)));
    const double tick = step * (whole / step > 20 ? 5 : whole / step > 8 ? 2 : 1);
    text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#333333\"/>\n",
                         kLeft, y, kWidth - kRight, y);
    for (int i = 0; i * tick <= whole; ++i) {
      const double at = kLeft + (kWidth - kLeft - kRight) * i * tick / whole;
      text_ += fmt::format(
          "<line x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\" stroke=\"#333333\"/>\n"
          "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>\n",
          at, y, y + 5, y + 18, i * tick);
    }
    text_ += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">ms</text>\n", kWidth - kRight,
                         y + 34);
  }

  std::vector<FrameTiming> pictures_;
  double clock_ns_;
  Cycle begin_, end_;
  std::string text_;
};

}  // namespace

std::string timeline_svg(const std::vector<FrameTiming>& pictures, double clock_ns) {
  return Timeline(pictures, clock_ns).svg();
}

}  // namespace cigsim
