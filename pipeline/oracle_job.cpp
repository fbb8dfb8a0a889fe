#include "pipeline/oracle_job.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"
#include "pipeline/concrete.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/techniques/isr_oracle.h"

namespace lightbench {
namespace {

constexpr double kCeilingNoise = 1.5;  // of 255

bool has_oracle(const JobVariant& variant) {
  if (variant.technique != "isr") return false;
  return variant_params(variant).boolean("direct");
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
    const GivenParams limits = isr_oracle_limits(variant_params(variant));
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

int reference_bounces(const Job& job) {
  const auto reference = std::ranges::find(job.references, job.primary_reference, &JobReference::name);
  return find_reference_kind(reference->kind, "").bounces(reference_params(*reference));
}

bool gives_ceiling(const JobVariant& variant, int bounces) {
  const Technique& technique = find_technique(variant.technique, "");
  return technique.offline && !technique.limited &&
         technique_bounces(technique, variant_params(variant)) == bounces;
}

void keep_only(Job& job, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (std::ranges::find(job.variants, name, &JobVariant::name) == job.variants.end())
      throw Error(
          fmt::format("there is no variant '{}'{}", name, did_you_mean(name, row_names(job.variants))),
          job.file.string());
  const int bounces = reference_bounces(job);
  std::erase_if(job.variants, [&](const JobVariant& variant) {
    return std::ranges::find(names, variant.name) == names.end() && variant.name != job.baseline &&
           !gives_ceiling(variant, bounces);
  });
}

void add_ceiling(Job& job) {
  const int bounces = reference_bounces(job);
  if (std::ranges::any_of(job.variants,
                          [&](const JobVariant& variant) { return gives_ceiling(variant, bounces); }))
    return;
  JobVariant ceiling;
  ceiling.name = free_name(job, "ceiling");
  ceiling.technique = "path_tracer";
  ceiling.params = {{"bounces", static_cast<long long>(bounces)}, {"noise", kCeilingNoise}};
  job.variants.push_back(std::move(ceiling));
}

}  // namespace

OracleJob oracle_job(const Job& job, const std::vector<std::string>& only) {
  const std::string where = job.file.string();
  if (job.primary_reference.empty()) throw Error("an oracle needs a reference, and the job has none", where);
  if (job.baseline.empty())
    throw Error("an oracle is measured by its gain over a baseline, and the job has none", where);
  OracleJob result{job, {}};
  result.job.name += "-oracle";
  result.job.variants = expand_sweeps(job.variants);
  result.job.gates.clear();
  if (!only.empty()) keep_only(result.job, only);
  add_oracles(result);
  if (result.pairs.empty())
    throw Error(
        "no variant is of technique 'isr' and shows direct light, so there is nothing that an oracle could "
        "be "
        "of",
        where);
  add_ceiling(result.job);
  if (std::ranges::find(job.metrics, "gain") == job.metrics.end()) result.job.metrics.emplace_back("gain");
  return result;
}

}  // namespace lightbench
