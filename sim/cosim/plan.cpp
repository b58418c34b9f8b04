// SPDX-License-Identifier: MIT
#include "sim/cosim/plan.hpp"

namespace cigsim::cosim {

void choose_variants(ComparePlan& plan) {
  RtlNeeds needs;
  for (const auto& database : plan.databases) needs = needs.with(RtlNeeds::of(*database));
  plan.variants.clear();
  for (const Stage stage : plan.stages)
    plan.variants.push_back(rtl_variant(stage, needs, plan.description));
}

}  // namespace cigsim::cosim
