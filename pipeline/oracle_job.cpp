#include "pipeline/oracle_job.h"

#include <algorithm>

#include "base/error.h"
#include "pipeline/concrete.h"
#include "pipeline/references.h"
#include "renderer/techniques/isr_oracle.h"

namespace lightbench {
namespace {

constexpr double kCeilingNoise = 1.5;  // of 255

bool has_oracle(const JobVariant& variant) {
  if (variant.technique != "isr") return false;
  const ParamValues params = variant_params(variant);
  return params.text("visibility") == "bitmask" && params.boolean("direct");
}

/// What a variant sees.
GivenParams limits_of(const JobVariant& variant) {
  const ParamValues params = variant_params(variant);
  GivenParams limits;
  for (const char* name : isr_oracle_limits()) limits[name] = params.all().at(name);
  return limits;
}

bool is_taken(const Job& job, const std::string& name) {
  return std::ranges::find(job.variants, name, &JobVariant::name) != job.variants.end() ||
         std::ranges::find(job.references, name, &JobReference::name) != job.references.end();
}

std::string free_name(const Job& job, const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; is_taken(job, name); ++i) name = wanted + " " + std::to_string(i);
  return name;
}

void add_oracles(OracleJob& to) {
  const std::vector<JobVariant> variants = to.job.variants;
  std::vector<JobVariant> oracles;
  for (const JobVariant& variant : variants) {
    if (!has_oracle(variant)) continue;
    const GivenParams limits = limits_of(variant);
    const auto known = std::ranges::find(oracles, limits, &JobVariant::params);
    if (known != oracles.end()) {
      to.pairs.push_back({variant.name, known->name});
      continue;
    }
    JobVariant oracle;
    oracle.name = free_name(to.job, variant.name + ", oracle");
    oracle.technique = isr_oracle_technique().name;
    oracle.params = limits;
    const auto place = std::ranges::find(to.job.variants, variant.name, &JobVariant::name);
    to.job.variants.insert(place + 1, oracle);
    to.pairs.push_back({variant.name, oracle.name});
    oracles.push_back(std::move(oracle));
  }
}

void add_ceiling(Job& job) {
  const auto reference = std::ranges::find(job.references, job.primary_reference, &JobReference::name);
  const int bounces = find_reference_kind(reference->kind, "").bounces(reference_params(*reference));
  const auto gives_ceiling = [&](const JobVariant& variant) {
    const Technique& technique = find_technique(variant.technique, "");
    return technique.offline && !technique.limited &&
           technique_bounces(technique, variant_params(variant)) == bounces;
  };
  if (std::ranges::any_of(job.variants, gives_ceiling)) return;
  JobVariant ceiling;
  ceiling.name = free_name(job, "ceiling");
  ceiling.technique = "path_tracer";
  ceiling.params = {{"bounces", static_cast<long long>(bounces)}, {"noise", kCeilingNoise}};
  job.variants.push_back(std::move(ceiling));
}

}  // namespace

OracleJob oracle_job(const Job& job) {
  const std::string where = job.file.string();
  if (job.primary_reference.empty()) throw Error("an oracle needs a reference, and the job has none", where);
  if (job.baseline.empty())
    throw Error("an oracle is measured by its gain over a baseline, and the job has none", where);
  OracleJob result{job, {}};
  result.job.name += "-oracle";
  result.job.variants = expand_sweeps(job.variants);
  result.job.gates.clear();
  add_oracles(result);
  if (result.pairs.empty())
    throw Error(
        "no variant of technique 'isr' has visibility: 'bitmask' (as presets fast and best do), so "
        "there is nothing that an oracle could be of",
        where);
  add_ceiling(result.job);
  if (std::ranges::find(job.metrics, "gain") == job.metrics.end()) result.job.metrics.emplace_back("gain");
  return result;
}

}  // namespace lightbench
