#include <cmath>
#include <limits>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "base/json_bytes.h"
#include "base/json_reader.h"
#include "reports/run_report.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

template <typename T, typename Of>
concept MaybeConst = std::is_same_v<std::remove_const_t<T>, Of>;

// Each structure names its fields once, in the order of the file; a Writer and a Reader visit them.
// `optional` fields are left out of the file where they are empty, false or 0.

template <typename Archive, typename T>
void visit(Archive& archive, T& pass) requires std::is_same_v<std::remove_const_t<T>, PassSeconds> {
  archive.required("name", pass.name);
  archive.required("seconds", pass.seconds);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& credit) requires std::is_same_v<std::remove_const_t<T>, ReportCredit> {
  archive.required("piece", credit.piece);
  archive.optional("creator", credit.creator);
  archive.optional("license", credit.license);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& scene) requires std::is_same_v<std::remove_const_t<T>, ReportScene> {
  archive.required("name", scene.name);
  archive.required("file", scene.file);
  archive.required("triangles", scene.triangles);
  archive.optional("hash", scene.hash);
  archive.optional("warnings", scene.warnings);
  archive.optional("credits", scene.credits);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& frame) requires std::is_same_v<std::remove_const_t<T>, ReportFrame> {
  archive.required("view", frame.view);
  archive.required("time", frame.time);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& sequence) requires std::is_same_v<std::remove_const_t<T>, ReportSequence> {
  archive.required("scene", sequence.scene);
  archive.required("name", sequence.name);
  archive.required("frames", sequence.frames);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& source) requires std::is_same_v<std::remove_const_t<T>, ReportImageSource> {
  archive.required("name", source.name);
  archive.required("kind", source.kind);
  archive.optional("params", source.params);
  archive.required("bounces", source.bounces);
  archive.optional("offline", source.offline);
  archive.optional("external", source.external);
  archive.optional("limited", source.limited);
  archive.optional("tool", source.tool);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& image) requires std::is_same_v<std::remove_const_t<T>, ReportImage> {
  archive.required("scene", image.scene);
  archive.required("view", image.view);
  archive.required("source", image.source);
  archive.required("is_reference", image.is_reference);
  archive.required("outcome", image.outcome);
  archive.optional("error", image.error);
  archive.optional("png", image.png);
  archive.optional("exr", image.exr);
  archive.optional("pov", image.pov);
  archive.optional("key", image.key);
  archive.required("seconds", image.seconds);
  archive.optional("cpu_seconds", image.cpu_seconds);
  archive.optional("noise", image.noise);
  archive.optional("mean_luminance", image.mean_luminance);
  archive.optional("ray_rates", image.ray_rates);
  archive.required("cached", image.cached);
  archive.required("contended", image.contended);
  archive.optional("passes", image.passes);
  archive.optional("warnings", image.warnings);
  archive.optional("buffers", image.buffers);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& score) requires std::is_same_v<std::remove_const_t<T>, ReportScore> {
  archive.required("scene", score.scene);
  archive.required("view", score.view);
  archive.required("variant", score.variant);
  archive.required("reference", score.reference);
  archive.required("outcome", score.outcome);
  archive.optional("error", score.error);
  archive.optional("metrics", score.metrics);
  archive.optional("difference_png", score.difference_png);
  archive.optional("heat_png", score.heat_png);
  archive.optional("baseline_difference_png", score.baseline_difference_png);
  archive.optional("warnings", score.warnings);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& object) requires std::is_same_v<std::remove_const_t<T>, ReportObject> {
  archive.required("scene", object.scene);
  archive.required("object", object.object);
  archive.required("variants", object.variants);
  archive.required("outcome", object.outcome);
  archive.optional("error", object.error);
  archive.required("seconds", object.seconds);
  archive.optional("cpu_seconds", object.cpu_seconds);
  archive.required("cached", object.cached);
  archive.required("contended", object.contended);
  archive.optional("noise", object.noise);
  archive.optional("ray_rates", object.ray_rates);
  archive.optional("numbers", object.numbers);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& view) requires std::is_same_v<std::remove_const_t<T>, ReportGateView> {
  archive.required("scene", view.scene);
  archive.required("view", view.view);
  archive.optional("variant", view.variant);
  archive.required("state", view.state);
  archive.optional("detail", view.detail);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& gate) requires std::is_same_v<std::remove_const_t<T>, ReportGate> {
  archive.required("text", gate.text);
  archive.optional("name", gate.name);
  archive.required("state", gate.state);
  archive.optional("detail", gate.detail);
  archive.optional("views", gate.views);
}

template <typename Archive, typename T>
void visit(Archive& archive, T& report) requires std::is_same_v<std::remove_const_t<T>, RunReport> {
  archive.required("format", report.format);
  archive.required("job", report.job);
  archive.required("job_file", report.job_file);
  archive.required("started", report.started);
  archive.required("seconds", report.seconds);
  archive.required("width", report.width);
  archive.required("height", report.height);
  archive.required("samples", report.samples);
  archive.optional("partial", report.partial);
  archive.optional("baseline", report.baseline);
  archive.optional("primary_reference", report.primary_reference);
  archive.required("metric_names", report.metric_names);
  archive.required("tools", report.tools);
  archive.required("scenes", report.scenes);
  archive.optional("sequences", report.sequences);
  archive.required("variants", report.variants);
  archive.required("references", report.references);
  archive.required("images", report.images);
  archive.required("scores", report.scores);
  archive.optional("bakes", report.bakes);
  archive.optional("compressions", report.compressions);
  archive.required("gates", report.gates);
  archive.optional("warnings", report.warnings);
}

constexpr const char* kOutcomeNames[] = {"ok", "failed", "skipped"};

template <typename T>
bool is_empty(const T& value) {
  if constexpr (std::is_arithmetic_v<T>)
    return value == T();
  else if constexpr (std::is_same_v<T, std::optional<double>>)
    return !value;
  else
    return value.empty();
}

class Writer {
 public:
  template <typename T>
  void required(const char* name, const T& value) {
    object_[name] = to_json(value);
  }
  template <typename T>
  void optional(const char* name, const T& value) {
    if (!is_empty(value)) required(name, value);
  }

  template <typename T>
  static Json to_json(const T& value) {
    if constexpr (std::is_same_v<T, double>) {
      return std::isfinite(value) ? Json(value) : Json(0.0);  // a time; JSON has no NaN
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      return Json(value);
    } else if constexpr (std::is_same_v<T, Outcome>) {
      return Json(kOutcomeNames[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_same_v<T, GateState>) {
      return Json(kGateStateNames[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      return to_json(*value);
    } else if constexpr (std::is_same_v<T, MetricValue>) {
      if (value.value && std::isfinite(*value.value)) return Json(*value.value);
      return Json{{"undefined", value.value ? "not a finite number" : value.undefined_because}};
    } else {
      Writer writer;
      visit(writer, value);
      return std::move(writer.object_);
    }
  }
  template <typename T>
  static Json to_json(const std::vector<T>& values) {
    Json array = Json::array();
    for (const T& value : values) array.push_back(to_json(value));
    return array;
  }
  template <typename T>
  static Json to_json(const std::map<std::string, T>& values) {
    Json object = Json::object();
    for (const auto& [name, value] : values) object[name] = to_json(value);
    return object;
  }

 private:
  Json object_ = Json::object();
};

class Reader {
 public:
  explicit Reader(const JsonValue& value) : object_(value) {}

  template <typename T>
  void required(const char* name, T& value) {
    read(object_.at(name), value);
  }
  template <typename T>
  void optional(const char* name, T& value) {
    if (const auto found = object_.find(name)) read(*found, value);
  }

  template <typename T>
  static void read(const JsonValue& json, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = json.boolean();
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) {
      value = json.number();
    } else if constexpr (std::is_integral_v<T>) {
      value = static_cast<T>(json.integer(0, std::numeric_limits<int>::max()));
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = json.text();
    } else if constexpr (std::is_same_v<T, Outcome>) {
      read_enum(json, kOutcomeNames, value);
    } else if constexpr (std::is_same_v<T, GateState>) {
      read_enum(json, kGateStateNames, value);
    } else if constexpr (std::is_same_v<T, MetricValue>) {
      read_metric_value(json, value);
    } else {
      Reader reader(json);
      visit(reader, value);
      reader.object_.finish();
      if constexpr (std::is_same_v<T, ReportSequence>)
        if (value.frames.empty()) json.fail("a sequence has at least one frame");
    }
  }
  template <typename T>
  static void read(const JsonValue& json, std::vector<T>& values) {
    for (const JsonValue& item : json.items()) read(item, values.emplace_back());
  }
  template <typename T>
  static void read(const JsonValue& json, std::map<std::string, T>& values) {
    JsonObject object = json.object();
    for (const std::string& key : object.keys()) read(object.at(key), values[key]);
  }

 private:
  template <typename Enum, std::size_t Count>
  static void read_enum(const JsonValue& json, const char* const (&all)[Count], Enum& value) {
    const std::vector<std::string> names(std::begin(all), std::end(all));
    const std::string name = json.choice(names);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) value = static_cast<Enum>(i);
  }
  static void read_metric_value(const JsonValue& json, MetricValue& value) {
    if (json.is_number()) {
      value = MetricValue::of(json.number());
      return;
    }
    JsonObject object = json.object();
    value = MetricValue::undefined(object.at("undefined").text());
    object.finish();
  }

  JsonObject object_;
};

}  // namespace

std::string run_report_to_json(const RunReport& report) {
  return json_text(Writer::to_json(report), 1) + "\n";
}

RunReport run_report_from_json(const std::string& text, const std::string& file) {
  const JsonValue json = JsonValue::parse(text, file, kOwnJson);
  const JsonValue format = json.object().at("format");
  if (format.integer() != kRunFormatVersion)
    format.fail("this is a run of format " + std::to_string(format.integer()) +
                ", this lightbench reads format " + std::to_string(kRunFormatVersion));
  RunReport report;
  Reader::read(json, report);
  return report;
}

}  // namespace lightbench
