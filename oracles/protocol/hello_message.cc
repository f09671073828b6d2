#include "oracles/protocol/hello_message.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"

namespace touchstone {
namespace {

// The functions of this name below hide those of the headers.
using touchstone::ToJson;

constexpr std::pair<const char*, bool Capability::*> kGives[] = {
    {"depth", &Capability::depth},
    {"distance", &Capability::distance},
    {"normal", &Capability::normal},
    {"manifold", &Capability::manifold},
    {"witnesses", &Capability::witnesses},
    {"penetrating_witnesses", &Capability::penetrating_witnesses}};

Json ToJson(const Capability& capability) {
  Json json;
  if (!capability.supported) {
    json["unsupported"] = capability.reason;
    return json;
  }
  json["family"] = capability.family;
  Json& gives = json["gives"] = Json::array();
  for (const auto& [name, member] : kGives) {
    if (capability.*member) gives.push_back(name);
  }
  if (!capability.documented_by.empty()) {
    json["documented_error"] = {{"length", ToJson(capability.documented_error)},
                                {"share", ToJson(capability.documented_relative_error)},
                                {"by", capability.documented_by}};
  }
  return json;
}

// The pairs of shapes with the same capability, in one entry each.
Json ContactJson(const OracleInfo& info) {
  Json entries = Json::array();
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const auto A = static_cast<ShapeKind>(a);
      const auto B = static_cast<ShapeKind>(b);
      const Json capability = ToJson(info.For(A, B));
      const Json pair = Json::array({NameOf(A), NameOf(B)});
      const auto same = std::ranges::find_if(entries, [&](const Json& entry) {
        Json without_pairs = entry;
        without_pairs.erase("pairs");
        return without_pairs == capability;
      });
      if (same != entries.end()) {
        (*same)["pairs"].push_back(pair);
        continue;
      }
      Json entry = {{"pairs", Json::array({pair})}};
      entry.update(capability);
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

Json ToJson(const WorldParameter& parameter) {
  return {{"name", parameter.name},
          {"here", ToJson(parameter.here)},
          {"shipped", ToJson(parameter.shipped)},
          {"least", ToJson(parameter.least)},
          {"most", ToJson(parameter.most)},
          {"whole", parameter.whole},
          {"what", parameter.what},
          {"why", parameter.why}};
}

Json WorldJson(const OracleInfo& info) {
  Json json;
  Json supports = Json::array();
  Json unsupported = Json::object();
  for (int i = 0; i < kWorldFeatures; ++i) {
    const auto feature = static_cast<WorldFeature>(i);
    if (info.For(feature).supported)
      supports.push_back(NameOf(feature));
    else
      unsupported[std::string(NameOf(feature))] = info.For(feature).reason;
  }
  json["supports"] = std::move(supports);
  json["unsupported"] = std::move(unsupported);
  if (info.slop != 0) {
    json["slop"] = {{"length", ToJson(info.slop)}, {"by", info.slop_documented_by}};
  }
  if (info.sleep_speed != 0) {
    json["sleep_speed"] = {{"speed", ToJson(info.sleep_speed)},
                           {"by", info.sleep_documented_by}};
  }
  if (info.documented_rotation_error)
    json["rotation_error"] = {{"error", ToJson(*info.documented_rotation_error)},
                              {"by", "the oracle " + info.name}};
  if (info.stated_order != 1) {
    json["order"] = {{"order", ToJson(info.stated_order)}, {"by", info.order_stated_by}};
  }
  if (!info.softness.empty()) json["softness"] = info.softness;
  Json& parameters = json["parameters"] = Json::array();
  for (const WorldParameter& parameter : info.parameters)
    parameters.push_back(ToJson(parameter));
  return json;
}

ShapeKind KindFrom(const Received& json) {
  const std::string name = json.Text();
  for (int kind = 0; kind < kShapeKinds; ++kind) {
    if (name == NameOf(static_cast<ShapeKind>(kind))) return static_cast<ShapeKind>(kind);
  }
  json.Fail("the name of a shape");
}

// A length or a speed that an author states, with its source.
double StatedFrom(const Received& json, std::string_view key, std::string& by) {
  const double stated = json[key].Number();
  if (!(std::isfinite(stated) && stated >= 0)) json[key].Fail("a finite number >= 0");
  by = json["by"].Text();
  if (by.empty()) json["by"].Fail("the source of the number");
  return stated;
}

Capability CapabilityFrom(const Received& json) {
  Capability capability;
  if (const auto reason = json.Find("unsupported")) {
    capability.reason = reason->Text();
    if (capability.reason.empty()) reason->Fail("a reason");
    return capability;
  }
  capability.supported = true;
  capability.family = json["family"].Text();
  if (capability.family.empty()) json["family"].Fail("the name of an algorithm");
  for (const Received& given : json["gives"].Items()) {
    const std::string name = given.Text();
    const auto found = std::ranges::find(
        kGives, name, [](const auto& g) { return std::string_view(g.first); });
    if (found == std::end(kGives)) {
      given.Fail(
          "depth, distance, normal, manifold, witnesses or "
          "penetrating_witnesses");
    }
    capability.*(found->second) = true;
  }
  if (const auto error = json.Find("documented_error")) {
    capability.documented_error = StatedFrom(*error, "length", capability.documented_by);
    capability.documented_relative_error =
        StatedFrom(*error, "share", capability.documented_by);
    if (capability.documented_relative_error > 1) (*error)["share"].Fail("at most 1");
  }
  return capability;
}

// The ordered pairs of an entry: "pairs", or all of "shapes".
std::vector<std::pair<ShapeKind, ShapeKind>> PairsFrom(const Received& entry) {
  std::vector<std::pair<ShapeKind, ShapeKind>> pairs;
  if (const auto shapes = entry.Find("shapes")) {
    const std::vector<Received> kinds = shapes->Items();
    for (const Received& a : kinds) {
      for (const Received& b : kinds) pairs.emplace_back(KindFrom(a), KindFrom(b));
    }
    return pairs;
  }
  for (const Received& pair : entry["pairs"].Items()) {
    const std::vector<Received> kinds = pair.Items(2);
    pairs.emplace_back(KindFrom(kinds[0]), KindFrom(kinds[1]));
  }
  return pairs;
}

void SetCapabilities(const Received& json, OracleInfo& info) {
  for (auto& row : info.capabilities) {
    for (Capability& capability : row)
      capability.reason = info.name + " does not answer this pair";
  }
  for (const Received& entry : json.Items()) {
    const Capability capability = CapabilityFrom(entry);
    for (const auto& [a, b] : PairsFrom(entry))
      info.capabilities[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] =
          capability;
  }
}

std::size_t FeatureNamed(const std::string& name, const Received& json) {
  for (int i = 0; i < kWorldFeatures; ++i) {
    if (name == NameOf(static_cast<WorldFeature>(i))) return static_cast<std::size_t>(i);
  }
  json.Fail("the name of a feature of a world");
}

WorldParameter ParameterFrom(const Received& json) {
  WorldParameter parameter;
  parameter.name = json["name"].Text();
  parameter.here = json["here"].Number();
  parameter.shipped = json["shipped"].Number();
  parameter.least = json["least"].Number();
  parameter.most = json["most"].Number();
  parameter.whole = json["whole"].Truth();
  parameter.what = json["what"].Text();
  parameter.why = json["why"].Text();
  for (const auto& [key, value] :
       {std::pair("here", parameter.here), std::pair("shipped", parameter.shipped)}) {
    const std::string expected = Refusal(parameter, value);
    if (!expected.empty()) json[key].Fail(expected);
  }
  return parameter;
}

void SetWorlds(const Received& json, OracleInfo& info) {
  info.simulates = true;
  for (const Received& feature : json["supports"].Items())
    info.world_capabilities[FeatureNamed(feature.Text(), feature)] = {true, ""};
  if (const auto unsupported = json.Find("unsupported")) {
    for (const std::string& name : unsupported->Keys()) {
      info.world_capabilities[FeatureNamed(name, *unsupported)] = {
          false, (*unsupported)[name].Text()};
    }
  }
  if (const auto slop = json.Find("slop"))
    info.slop = StatedFrom(*slop, "length", info.slop_documented_by);
  if (const auto sleep = json.Find("sleep_speed"))
    info.sleep_speed = StatedFrom(*sleep, "speed", info.sleep_documented_by);
  if (const auto error = json.Find("rotation_error")) {
    std::string by;
    info.documented_rotation_error = StatedFrom(*error, "error", by);
    if (*info.documented_rotation_error > 1) (*error)["error"].Fail("at most 1");
    info.settings.push_back(
        {"rotation error", fmt::format("{:.3g}", *info.documented_rotation_error),
         fmt::format(
             "the error of a step of free rotation that is granted, documented by "
             "{}",
             by)});
  }
  if (const auto order = json.Find("order")) {
    info.stated_order = StatedFrom(*order, "order", info.order_stated_by);
    if (info.stated_order < 1) order->Fail("an order of at least 1");
  }
  if (const auto parameters = json.Find("parameters")) {
    for (const Received& parameter : parameters->Items())
      info.parameters.push_back(ParameterFrom(parameter));
  }
  if (const auto softness = json.Find("softness")) {
    info.softness = softness->Text();
    if (std::ranges::find(info.parameters, info.softness, &WorldParameter::name) ==
        info.parameters.end()) {
      softness->Fail("the name of a parameter");
    }
  }
}

double RoundoffFrom(const Received& json) {
  const std::string precision = json.Text();
  if (precision == "double") return kDoubleRoundoff;
  if (precision == "float") return kFloatRoundoff;
  json.Fail("\"double\" or \"float\"");
}

}  // namespace

void PutHello(const OracleInfo& info, bool frames, Message& message) {
  Json& line = message.line;
  line["protocol"] = kProtocolVersion;
  line["name"] = info.name;
  line["library"] = info.library;
  line["version"] = info.version;
  line["precision"] = info.unit_roundoff == kFloatRoundoff ? "float" : "double";
  if (info.subtracts_first) line["subtracts_first"] = true;
  line["frames"] = frames;
  Json& settings = line["settings"] = Json::array();
  for (const Setting& setting : info.settings) {
    settings.push_back(
        {{"name", setting.name}, {"value", setting.value}, {"why", setting.why}});
  }
  if (info.AnswersContacts()) line["contact"] = ContactJson(info);
  if (info.simulates) line["world"] = WorldJson(info);
}

Hello HelloFrom(const Message& message, const std::string& name) {
  const Received line(message.line, "hello");
  if (const auto error = line.Find("error"))
    throw ProtocolError("answered hello with an error: " + error->Text());
  line["protocol"].Whole(kProtocolVersion, kProtocolVersion);
  Hello hello;
  OracleInfo& info = hello.info;
  info.name = name.empty() ? line["name"].Text() : name;
  info.library = line["library"].Text();
  info.version = line["version"].Text();
  for (const char* key : {"name", "library", "version"}) {
    const std::string text = line[key].Text();
    const bool is_printable =
        std::ranges::none_of(text, [](unsigned char c) { return c < ' ' || c == 127; });
    if (text.empty() || !is_printable) line[key].Fail("a name that can be printed");
  }
  info.unit_roundoff = RoundoffFrom(line["precision"]);
  if (const auto subtracts = line.Find("subtracts_first"))
    info.subtracts_first = subtracts->Truth();
  if (const auto frames = line.Find("frames")) hello.frames = frames->Truth();
  if (const auto settings = line.Find("settings")) {
    for (const Received& setting : settings->Items()) {
      info.settings.push_back(
          {setting["name"].Text(), setting["value"].Text(), setting["why"].Text()});
    }
  }
  for (WorldCapability& capability : info.world_capabilities)
    capability.reason = "not among what " + info.name + " simulates";
  const auto contact = line.Find("contact");
  const auto world = line.Find("world");
  if (!contact && !world)
    throw ProtocolError("hello: expected \"contact\" or \"world\" in it, or both");
  static const Json kNothing = Json::array();
  SetCapabilities(contact ? *contact : Received(kNothing, "hello"), info);
  if (world) SetWorlds(*world, info);
  return hello;
}

}  // namespace touchstone
