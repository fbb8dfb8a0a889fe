#include "base/error.h"
#include "fuzz_input.h"
#include "pipeline/job_file.h"

namespace lightbench::fuzz {

/// A job file. What is read can be written, and reads back the same.
void fuzz_job(std::string_view bytes) {
  const Job job = parse_job(std::string(bytes), "/jobs/job.json");
  const std::string text = job_text(job);
  try {
    require(job_text(parse_job(text, job.file)) == text, "a job that reads back as another one");
  } catch (const Error& error) {
    require(false, "a job that was written is refused: " + std::string(error.what()) + "\n" + text);
  }
}

}  // namespace lightbench::fuzz
