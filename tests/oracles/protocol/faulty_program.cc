// An oracle for pairs of spheres that fails on one question: that with a sphere A of
// radius kFatal. Its first argument says how.

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {

using Json = nlohmann::ordered_json;

constexpr double kFatal = 0.13;

Json Hello() {
  return {{"protocol", 1},
          {"name", "faulty"},
          {"library", "none"},
          {"version", "1"},
          {"precision", "double"},
          {"contact",
           {{{"pairs", Json::array({Json::array({"sphere", "sphere"})})},
             {"family", "closed"},
             {"gives", {"depth", "distance", "normal"}}}}}};
}

Json AnswerTo(const Json& query) {
  double squares = 0;
  Json normal = Json::array();
  for (std::size_t i = 0; i < 3; ++i) {
    const double d =
        query["B"]["position"][i].get<double>() - query["A"]["position"][i].get<double>();
    squares += d * d;
    normal.push_back(d);
  }
  const double distance = std::sqrt(squares);
  for (Json& x : normal) x = x.get<double>() / distance;
  const double gap =
      distance - query["A"]["radius"].get<double>() - query["B"]["radius"].get<double>();
  return {{"touching", gap <= 0}, {"separation", gap}, {"normal", normal}};
}

[[noreturn]] void SayNothingMore() {
  while (true) pause();
}

// Fails in the way `how`, if that is before an answer.
void FailBefore(const std::string& how, const std::string& file) {
  if (how == "abort") {
    std::cerr << "assertion failed\n";
    std::abort();
  }
  if (how == "exit") std::exit(3);
  if (how == "hang" || how == "lost") SayNothingMore();
  if (how == "work") {
    while (getppid() > 0) {
    }
  }
  if (how == "garbage") std::cout << "depth is 0.3\n";
  if (how == "flood") {
    while (true) std::cout << "no end ";
  }
  if (how == "messages") {
    for (int i = 0; i < 100'000; ++i) std::cerr << "a warning, again and again\n";
  }
  if (how.starts_with("die once") && !std::ifstream(file)) {
    std::ofstream(file) << getpid();
    std::abort();
  }
}

// Answers until the end of the input.
void Converse(const std::string& how, const std::string& file) {
  if (how == "banner") std::cout << "faulty engine, build 7\n" << std::flush;
  if (how == "pid") std::ofstream(file) << getpid();
  for (std::string text; std::getline(std::cin, text);) {
    const Json message = Json::parse(text);
    if (message["method"] == "bye") return;
    Json answer = {{"id", message["id"]}};
    if (message["method"] == "hello") {
      answer.update(Hello());
      if (how == "old") answer["protocol"] = 0;
      if (how == "shapeless") answer["contact"][0]["pairs"][0][0] = "ball";
    } else {
      Json& answers = answer["answers"] = Json::array();
      bool is_fatal = false;
      for (const Json& query : message["queries"]) {
        Json one = AnswerTo(query);
        if (query["A"]["radius"] == kFatal) {
          is_fatal = true;
          FailBefore(how, file);
          if (how == "nan") one["separation"] = "NaN";
          if (how == "short normal") one["normal"] = {1, 0};
          if (how == "refuse" || how == "die once and refuse")
            one = {{"error", "no such ball"}};
        }
        answers.push_back(one);
      }
      if (is_fatal && how == "few answers") answers.erase(0);
      if (is_fatal && how == "another id") answer["id"] = 77;
      if (is_fatal && how == "error")
        answer = {{"id", message["id"]}, {"error", "tired"}};
    }
    std::cout << answer.dump() << '\n' << std::flush;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Converse(argc > 1 ? argv[1] : "", argc > 2 ? argv[2] : "");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
