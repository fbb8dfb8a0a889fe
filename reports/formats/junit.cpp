#include "reports/formats/junit.h"

#include <fmt/format.h>

#include "reports/escape.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

struct Suite {
  std::string name;
  std::string cases;
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
  double seconds = 0;
};

Suite suite_named(const std::string& name) {
  Suite suite;
  suite.name = name;
  return suite;
}

std::string problem(const char* element, const char* type, const std::string& message) {
  // The message again as text: some viewers show only the one, some only the other.
  return fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{2}</{0}>\n", element, type,
                     escape_markup(message));
}

std::string skipped(const std::string& message) {
  return fmt::format("      <skipped message=\"{}\"/>\n", escape_markup(message));
}

void add_case(Suite& suite, const std::string& group, const std::string& name, double seconds,
              const std::string& body) {
  ++suite.tests;
  suite.seconds += seconds;
  suite.cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                             escape_markup(plain_line(group)), escape_markup(plain_line(name)), seconds);
  suite.cases += body.empty() ? "/>\n" : ">\n" + body + "    </testcase>\n";
}

void add_task(Suite& suite, const std::string& group, const std::string& name, double seconds,
              Outcome outcome, const std::string& error) {
  std::string body;
  if (outcome == Outcome::failed) {
    ++suite.errors;
    body = problem("error", "task failed", error.empty() ? "failed" : error);
  } else if (outcome == Outcome::skipped) {
    ++suite.skipped;
    body = skipped(error);
  }
  add_case(suite, group, name, seconds, body);
}

/// A gate, or one of the views that it holds for.
void add_gate(Suite& suite, const std::string& name, GateState state, const std::string& detail,
              bool partial) {
  std::string body;
  if (state == GateState::not_met) {
    ++suite.failures;
    body = problem("failure", "gate not met", detail);
  } else if (state == GateState::within_noise) {  // neither passed nor failed
    ++suite.skipped;
    body = skipped("within the reference's noise: " + detail);
  } else if (state == GateState::not_judged && partial) {
    ++suite.skipped;
    body = skipped("not judged: " + detail);
  } else if (state == GateState::not_judged) {  // no green light for what nobody measured
    ++suite.errors;
    body = problem("error", "gate not judged", "not judged: " + detail);
  }
  add_case(suite, "gate", name, 0, body);
}

std::string place(const ReportGateView& view) {
  return (view.variant.empty() ? "" : view.variant + " on ") + view.scene + "/" + view.view;
}

Suite gates_suite(const RunReport& report) {
  Suite suite = suite_named("gates");
  for (const ReportGate& gate : report.gates) {
    const std::string& name = gate.name.empty() ? gate.text : gate.name;  // none in runs of older versions
    if (gate.views.empty()) add_gate(suite, name, gate.state, gate.detail, report.partial);
    for (const ReportGateView& view : gate.views)
      add_gate(suite, name + ": " + place(view), view.state, view.detail, report.partial);
  }
  return suite;
}

Suite images_suite(const RunReport& report) {
  Suite suite = suite_named("images");
  for (const ReportImage& image : report.images)
    add_task(suite, image.scene + "/" + image.view, image.source, image.seconds, image.outcome, image.error);
  return suite;
}

Suite scores_suite(const RunReport& report) {
  Suite suite = suite_named("scores");
  for (const ReportScore& score : report.scores)
    add_task(suite, score.scene + "/" + score.view, score.variant + " against " + score.reference, 0,
             score.outcome, score.error);
  return suite;
}

Suite objects_suite(const RunReport& report) {
  Suite suite = suite_named("objects");
  const auto add = [&](const std::string& task, const ReportObject& object) {
    add_task(suite, object.scene, object_task(task, object), object.seconds, object.outcome, object.error);
  };
  for (const ReportObject& object : report.bakes) add("bake", object);
  for (const ReportObject& object : report.compressions) add("compression", object);
  return suite;
}

std::string counts(const Suite& suite) {
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"", suite.tests,
                     suite.failures, suite.errors, suite.skipped, suite.seconds);
}

}  // namespace

std::vector<ReportFile> write_junit(const RunReport& report) {
  Suite total;
  std::string body;
  for (const Suite& suite :
       {gates_suite(report), objects_suite(report), images_suite(report), scores_suite(report)}) {
    total.tests += suite.tests;
    total.failures += suite.failures;
    total.errors += suite.errors;
    total.skipped += suite.skipped;
    body += fmt::format("  <testsuite name=\"{}\" {} timestamp=\"{}\">\n{}  </testsuite>\n",
                        escape_markup(report.job + " " + suite.name), counts(suite),
                        escape_markup(report.started), suite.cases);
  }
  total.seconds = report.seconds;
  return {
      {"junit.xml", fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}"
                                "</testsuites>\n",
                                escape_markup(report.job), counts(total), body)}};
}

}  // namespace lightbench
