// SPDX-License-Identifier: MIT
#include "sim/pipeline/connections.hpp"

#include <sstream>
#include <string>

#include "models/boundary/trace_words.hpp"

namespace cigsim {
namespace {

// Words of frame starts and completions: one of a frame, and one of the next.
constexpr std::uint32_t kControlDepth = 2;

constexpr Stage kCalculator = Stage::kFrameCalculator, kPriority = Stage::kPriorityProcessor,
                kGeometry = Stage::kGeometryProcessor, kOrderer = Stage::kEdgeOrderer,
                kResolver = Stage::kPriorityResolver, kVideo = Stage::kVideoProcessor;

bool pins(const PipelineOptions& options, Stage stage) { return has_pins(options.levels[stage]); }

// From the sequencer, or to it, which has no pins.
Connection<FrameWord> start(const char* name, Stage to, const PipelineOptions& options,
                            const Clock& clock) {
  return {name, kControlDepth, options.stalls, false, pins(options, to), clock};
}
Connection<FrameWord> completion(const char* name, Stage from, const PipelineOptions& options,
                                 const Clock& clock) {
  return {name, kControlDepth, options.stalls, pins(options, from), false, clock};
}

template <class T>
Connection<T> link(const char* name, std::uint32_t depth, Stage from, Stage to,
                   const PipelineOptions& options, const Clock& clock) {
  return {name, depth, options.stalls, pins(options, from), pins(options, to), clock};
}

// Calls f(member, the stage that produces its words, whether they end lines).
template <class F>
void for_each_connection(F f) {
  f(&Connections::start_calculator, kCalculator, false);
  f(&Connections::calculated, kCalculator, false);
  f(&Connections::start_priority, kCalculator, false);
  f(&Connections::start_geometry, kCalculator, false);
  f(&Connections::start_orderer, kCalculator, false);
  f(&Connections::start_video, kCalculator, false);
  f(&Connections::edges_loaded, kOrderer, false);
  f(&Connections::faces_loaded, kVideo, false);
  f(&Connections::shown, kVideo, false);
  f(&Connections::items, kPriority, false);
  f(&Connections::edges, kGeometry, false);
  f(&Connections::faces, kGeometry, false);
  f(&Connections::crossings, kOrderer, true);
  f(&Connections::spans, kResolver, true);
}

template <class T>
void watch(Link<T>& link, const SystemcMachine::Probe& probe) {
  link.set_probe([probe, name = link.name()](const T& word, Cycle pushed, Cycle taken) {
    std::ostringstream text;
    text << word;
    probe(name, text.str(), pushed, taken);
  });
}

template <class T>
std::unique_ptr<LinkCheckBase> check_link(Link<T>& expected, Link<T>& got, Stage producer,
                                          std::uint32_t lines, const MismatchFunction& report) {
  return std::make_unique<LinkCheck<T>>(expected, got, std::string(name_of(producer)), lines,
                                        report);
}

}  // namespace

Connections::Connections(const PipelineOptions& o, const Clock& clock)
    : start_calculator(start("start_calculator", kCalculator, o, clock)),
      calculated(completion("calculated", kCalculator, o, clock)),
      start_priority(start("start_priority", kPriority, o, clock)),
      start_geometry(start("start_geometry", kGeometry, o, clock)),
      start_orderer(start("start_orderer", kOrderer, o, clock)),
      start_video(start("start_video", kVideo, o, clock)),
      edges_loaded(completion("edges_loaded", kOrderer, o, clock)),
      faces_loaded(completion("faces_loaded", kVideo, o, clock)),
      shown(completion("shown", kVideo, o, clock)),
      items(link<ItemWord>("items", o.description.links.items, kPriority, kGeometry, o, clock)),
      edges(link<EdgeWord>("edges", o.description.links.edges, kGeometry, kOrderer, o, clock)),
      faces(link<FaceWord>("faces", o.description.links.faces, kGeometry, kVideo, o, clock)),
      crossings(link<CrossingWord>("crossings", o.description.links.crossings, kOrderer, kResolver,
                                   o, clock)),
      spans(link<SpanWord>("spans", o.description.links.spans, kResolver, kVideo, o, clock)) {}

Connections::~Connections() = default;

void Connections::set_probe(const SystemcMachine::Probe& probe) {
  for_each_connection(
      [&](auto connection, Stage, bool) { watch((this->*connection).link, probe); });
}

std::vector<std::unique_ptr<LinkCheckBase>> Connections::check(Connections& expected,
                                                               std::uint32_t raster_lines,
                                                               const MismatchFunction& report) {
  std::vector<std::unique_ptr<LinkCheckBase>> checks;
  for_each_connection([&](auto connection, Stage producer, bool lines) {
    checks.push_back(check_link((expected.*connection).link, (this->*connection).link, producer,
                                lines ? raster_lines : 1, report));
  });
  return checks;
}

}  // namespace cigsim
