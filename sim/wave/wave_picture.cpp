// SPDX-License-Identifier: MIT
#include "sim/wave/wave_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>

#include "sim/markup.hpp"

namespace cigsim {
namespace {

// Lengths in pixels.
constexpr double kMargin = 14, kAxis = 44, kGap = 16;
constexpr double kRow = 25, kHeading = 32, kBlank = 12;
constexpr double kLane = 16;          // between the low and the high level
constexpr double kCharacter = 0.602;  // of a fixed-width font, a part of its size
constexpr double kText = 11, kSmallText = 9, kLabel = 12;
constexpr double kIndent = 10;
constexpr double kTick = 84;     // at least, between two lines of the axis
constexpr double kNarrow = 2.5;  // what is narrower cannot be told apart
constexpr double kSlant = 3.5;   // of a box's ends
constexpr double kPad = 7;       // beside a box's text

constexpr const char* kStyle =
    "text{font-family:ui-monospace,SFMono-Regular,Menlo,Consolas,'DejaVu Sans Mono',monospace}"
    ".h{font:600 12.5px system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;"
    "fill:#17324d}"
    ".n{font-size:12px;fill:#333d47}"
    ".a{font-size:11px;fill:#5b6773;text-anchor:middle}"
    ".c{font-size:11px;fill:#8592a0}"
    ".v,.w{font-size:11px;fill:#173a63;text-anchor:middle}"
    ".w{font-size:9px}"
    ".g{stroke:#e3e9f0;stroke-width:1}"
    ".r{stroke:#c9d4df;stroke-width:1}"
    ".b{fill:none;stroke:#13795b;stroke-width:1.5;stroke-linejoin:round}"
    ".f{fill:#d8f1e6}"
    ".d{fill:#7fc3a9}"
    ".q{fill:#edf3fb;stroke:#3b6cab;stroke-width:1.2;stroke-linejoin:round}"
    ".e{fill:#9db9de}"
    ".x{fill:#fbe3e1;stroke:#b42318;stroke-width:1.2;stroke-linejoin:round}"
    ".y{fill:#b42318}"
    ".z{fill:none;stroke:#b7791f;stroke-width:1.5}";

// With a thin space between thousands.
std::string spaced(double value) {
  std::string text = fmt::format("{:g}", std::round(value * 1000) / 1000);
  if (std::abs(value) >= 1e5) text = fmt::format("{:.0f}", value);
  const std::size_t whole = std::min(text.find('.'), text.size());
  for (std::size_t i = whole; i > 3 && whole > 4; i -= 3) text.insert(i - 3, "\xE2\x80\x89");
  return text;
}

double text_width(std::size_t characters, double size) {
  return static_cast<double>(characters) * size * kCharacter;
}

// 1, 2 or 5 times a power of ten, not below `least`.
double round_step(double least) {
  double step = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (factor * step >= least * (1 - 1e-9)) return factor * step;
  return 10 * step;
}

// A value between two changes.
struct Stretch {
  double begin, end;          // x
  bool open_begin, open_end;  // goes on beyond the window
  const std::string* value;
};

// Takes the scopes that all names of `which` share from these, if there are several.
template <class Which>
void drop_shared_scopes(std::vector<std::string>& names, Which&& which) {
  const std::string* model = nullptr;
  std::size_t shared = 0, count = 0;
  for (const std::string& name : names) {
    if (!which(name)) continue;
    if (count++ == 0) {
      model = &name;
      shared = name.rfind('.') + 1;
    }
    while (shared > 0 && name.compare(0, shared, *model, 0, shared) != 0)
      shared = shared < 2 ? 0 : model->rfind('.', shared - 2) + 1;
  }
  if (count < 2 || shared == 0) return;
  for (std::string& name : names)
    if (which(name)) name.erase(0, shared);
}

class Drawing {
 public:
  Drawing(const Wave& wave, const std::vector<WavePictureRow>& rows,
          const WavePictureOptions& options)
      : wave_(wave), rows_(rows), options_(options) {
    if (wave.last <= wave.first)
      throw std::invalid_argument("the window has no length; let it begin before it ends");
    std::size_t longest = 5;
    bool headings = false;
    for (const WavePictureRow& row : rows) {
      if (row.kind == ViewRow::Kind::kSignal) longest = std::max(longest, row.label.size());
      headings = headings || row.kind == ViewRow::Kind::kHeading;
      height_ += height_of(row);
    }
    indent_ = headings ? kIndent : 0;
    const double names = std::min(indent_ + text_width(longest, kLabel), options.width * 0.4);
    left_ = std::ceil(kMargin + names + kGap);
    right_ = options.width - kMargin;
    height_ += kAxis + kMargin;
    scale_ = (right_ - left_) / static_cast<double>(wave.last - wave.first);
  }

  std::string draw() {
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0} {1:.0f}\" role=\"img\" aria-label=\"waves from {2} to {3} ns\">\n",
        options_.width, height_, spaced(ns(wave_.first)), spaced(ns(wave_.last)));
    put("<style>{}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n", kStyle);
    put("<clipPath id=\"cigsim-window\"><rect x=\"{}\" width=\"{}\" "
        "height=\"{:.0f}\"/></clipPath>\n",
        left_, right_ - left_, height_);
    axis();
    double top = kAxis;
    for (const WavePictureRow& row : rows_) {
      draw_row(row, top);
      top += height_of(row);
    }
    out_ += "</svg>\n";
    return std::move(out_);
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... arguments) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(arguments)...);
  }

  static double height_of(const WavePictureRow& row) {
    switch (row.kind) {
      case ViewRow::Kind::kHeading:
        return kHeading;
      case ViewRow::Kind::kBlank:
        return kBlank;
      case ViewRow::Kind::kSignal:
        break;
    }
    return kRow;
  }

  double ns(WaveTime time) const { return static_cast<double>(time) * wave_.unit_ns; }
  double x(WaveTime time) const { return left_ + static_cast<double>(time - wave_.first) * scale_; }
  double x_of_ns(double t) const { return left_ + (t - ns(wave_.first)) * scale_ / wave_.unit_ns; }

  // Lines at the beginnings of cycles; in a window of less than two cycles, at round times.
  void axis() {
    const double per_ns = scale_ / wave_.unit_ns;
    const double cycle = options_.cycle_ns;
    const bool cycles = ns(wave_.last) - ns(wave_.first) >= 2 * cycle;
    const double least = kTick / per_ns;
    const double step =
        cycles ? cycle * round_step(std::max(1.0, least / cycle)) : round_step(least);
    const double top = kAxis - 8, bottom = height_ - kMargin / 2;
    if (cycles && cycle * per_ns >= 8 && step > cycle) lines(cycle, top + 4, bottom);
    lines(step, top, bottom);
    if (cycles) put("<text class=\"c\" x=\"{}\" y=\"16\">cycle</text>\n", kMargin);
    put("<text class=\"c\" x=\"{}\" y=\"31\">ns</text>\n", kMargin);
    for_lines(step, [&](double t) {
      const std::string time = spaced(t);
      const double half = text_width(time.size(), kText) / 2;
      const double at = std::min(x_of_ns(t), options_.width - half - 2);
      if (cycles) put("<text class=\"a\" x=\"{:.1f}\" y=\"16\">{}</text>", at, spaced(t / cycle));
      put("<text class=\"a\" x=\"{:.1f}\" y=\"31\">{}</text>\n", at, time);
    });
  }

  template <class F>
  void for_lines(double step, F&& f) const {
    const double first = std::ceil(ns(wave_.first) / step - 1e-9) + 0.0;  // not -0
    for (double n = first; n * step <= ns(wave_.last) * (1 + 1e-12); ++n) f(n * step);
  }

  void lines(double step, double top, double bottom) {
    out_ += "<path class=\"g\" d=\"";
    for_lines(step, [&](double t) { put("M{:.1f} {:.0f}V{:.0f}", x_of_ns(t), top, bottom); });
    out_ += "\"/>\n";
  }

  void draw_row(const WavePictureRow& row, double top) {
    if (row.kind == ViewRow::Kind::kBlank) return;
    if (row.kind == ViewRow::Kind::kHeading) {
      const double base = top + kHeading - 10;
      put("<text class=\"h\" x=\"{}\" y=\"{:.1f}\">{}</text>", kMargin, base,
          markup_escaped(row.label));
      put("<path class=\"r\" d=\"M{} {:.1f}H{}\"/>\n", kMargin, base + 5.5, right_);
      return;
    }
    const double middle = top + kRow / 2;
    const WaveTrace& trace = wave_.traces[row.trace];
    put("<g><title>{}{}</title>\n", markup_escaped(trace.signal.name),
        markup_escaped(trace.signal.range));
    const double space = left_ - kGap / 2 - kMargin - indent_;
    const auto fits = static_cast<std::size_t>(space / text_width(1, kLabel));
    const std::string label =
        row.label.size() <= fits ? row.label : "…" + row.label.substr(row.label.size() - fits + 1);
    put("<text class=\"n\" x=\"{}\" y=\"{:.1f}\">{}</text>\n", kMargin + indent_, middle + 4,
        markup_escaped(label));
    if (trace.signal.width == 1 && !trace.signal.real)
      draw_bit(trace, middle);
    else
      draw_word(trace, row, middle);
    out_ += "</g>\n";
  }

  std::vector<Stretch> stretches(const WaveTrace& trace) const {
    static const std::string none;
    const std::vector<WaveChange>& changes = trace.changes;
    std::vector<Stretch> list;
    if (changes.empty() || changes.front().time > wave_.first) {
      const bool never = changes.empty();
      list.push_back({left_, never ? right_ : x(changes.front().time), true, never, &none});
    }
    for (std::size_t i = 0; i < changes.size(); ++i) {
      if (changes[i].time >= wave_.last) break;
      const bool last = i + 1 == changes.size() || changes[i + 1].time >= wave_.last;
      list.push_back({x(changes[i].time), last ? right_ : x(changes[i + 1].time),
                      changes[i].time == wave_.first, last, &changes[i].value});
    }
    return list;
  }

  // Calls `one` for each stretch that is wide enough, and `bar(begin, end)` for a run of others.
  template <class One, class Bar>
  static void for_visible(const std::vector<Stretch>& list, One&& one, Bar&& bar) {
    for (std::size_t i = 0; i < list.size();) {
      std::size_t end = i;
      while (end < list.size() && list[end].end - list[end].begin < kNarrow) ++end;
      if (end - i >= 2) {
        bar(list[i].begin, list[end - 1].end);
        i = end;
      } else {
        one(list[i]);
        ++i;
      }
    }
  }

  void rectangle(const char* kind, double begin, double end, double middle) {
    put("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>\n", kind,
        begin, middle - kLane / 2, end - begin, kLane);
  }

  void draw_bit(const WaveTrace& trace, double middle) {
    const double high = middle - kLane / 2, low = middle + kLane / 2;
    std::string line, other;
    bool pen = false;  // the line goes on
    for_visible(
        stretches(trace),
        [&](const Stretch& s) {
          const char value = s.value->empty() ? 'x' : s.value->front();
          if (value == 'z')
            other += fmt::format("<path class=\"z\" d=\"M{:.1f} {}H{:.1f}\"/>\n", s.begin, middle,
                                 s.end);
          else if (value == 'x')
            other += fmt::format(
                "<rect class=\"x\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>\n",
                s.begin, high, s.end - s.begin, kLane);
          if (value == '1') rectangle("f", s.begin, s.end, middle);
          const bool level = value == '0' || value == '1';
          if (level) {
            const double y = value == '1' ? high : low;
            line += pen ? fmt::format("V{:.1f}", y) : fmt::format("M{:.1f} {:.1f}", s.begin, y);
            line += fmt::format("H{:.1f}", s.end);
          }
          pen = level;
        },
        [&](double begin, double end) {
          rectangle("d", begin, end, middle);
          pen = false;
        });
    out_ += other;
    if (!line.empty()) put("<path class=\"b\" d=\"{}\"/>\n", line);
  }

  void draw_word(const WaveTrace& trace, const WavePictureRow& row, double middle) {
    for_visible(
        stretches(trace),
        [&](const Stretch& s) {
          const bool digits = !trace.signal.real;
          const auto all = [&](char c) {
            return digits && !s.value->empty() &&
                   s.value->find_first_not_of(c) == std::string::npos;
          };
          if (all('z')) {
            put("<path class=\"z\" d=\"M{:.1f} {}H{:.1f}\"/>\n", s.begin, middle, s.end);
            return;
          }
          const bool unknown =
              s.value->empty() || (digits && s.value->find_first_of("xz") != std::string::npos);
          box(s, middle, unknown);
          box_text(s, middle,
                   s.value->empty() ? "x" : (digits ? digits_text(*s.value, row) : *s.value),
                   unknown);
        },
        [&](double begin, double end) { rectangle("e", begin, end, middle); });
  }

  static std::string digits_text(const std::string& digits, const WavePictureRow& row) {
    const std::string text = value_text(digits, row.radix);
    return row.names ? row.names->of(text) : text;
  }

  // Open ends lie outside the window, which cuts them off.
  void box(const Stretch& s, double middle, bool unknown) {
    const double high = middle - kLane / 2, low = middle + kLane / 2;
    const double begin = s.open_begin ? s.begin - 2 * kSlant : s.begin;
    const double end = s.open_end ? s.end + 2 * kSlant : s.end;
    const double slant = std::min(kSlant, (end - begin) / 2);
    put("<path class=\"{}\" clip-path=\"url(#cigsim-window)\" d=\"M{:.1f} {:.1f}L{:.1f} "
        "{:.1f}H{:.1f}"
        "L{:.1f} {:.1f}L{:.1f} {:.1f}H{:.1f}Z\"/>\n",
        unknown ? "x" : "q", begin, middle, begin + slant, high, end - slant, end, middle,
        end - slant, low, begin + slant);
  }

  void box_text(const Stretch& s, double middle, const std::string& text, bool unknown) {
    const double space = s.end - s.begin - kPad;
    const bool large = text_width(text.size(), kText) <= space;
    if (!large && text_width(text.size(), kSmallText) > space) return;
    put("<text class=\"{}{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", large ? "v" : "w",
        unknown ? " y" : "", (s.begin + s.end) / 2, middle + (large ? 3.8 : 3.2),
        markup_escaped(text));
  }

  const Wave& wave_;
  const std::vector<WavePictureRow>& rows_;
  const WavePictureOptions& options_;
  std::string out_;
  double indent_ = 0, left_ = 0, right_ = 0, height_ = 0, scale_ = 1;
};

}  // namespace

std::string wave_picture(const Wave& wave, const std::vector<WavePictureRow>& rows,
                         const WavePictureOptions& options) {
  return Drawing(wave, rows, options).draw();
}

std::vector<std::string> short_names(const std::vector<std::string>& names) {
  std::vector<std::string> result = names;
  drop_shared_scopes(result, [](const std::string&) { return true; });
  drop_shared_scopes(result, [](const std::string& n) { return n.find('.') != n.npos; });
  if (std::set<std::string>(result.begin(), result.end()).size() <
      std::set<std::string>(names.begin(), names.end()).size())
    return names;
  return result;
}

}  // namespace cigsim
