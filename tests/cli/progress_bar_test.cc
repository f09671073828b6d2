#include "cli/progress_bar.h"

#include <cstddef>
#include <future>
#include <iostream>
#include <streambuf>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

/** Takes what is written to standard error, and tells when `wanted` was written. */
class Written : public std::streambuf {
 public:
  explicit Written(std::string wanted) : wanted_(std::move(wanted)) {
    replaced_ = std::cerr.rdbuf(this);
  }
  ~Written() override { std::cerr.rdbuf(replaced_); }

  /** Waits until `wanted` was written. */
  void Wait() { found_.get_future().wait(); }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    Take({text, static_cast<std::size_t>(size)});
    return size;
  }
  int overflow(int character) override {
    Take(std::string(1, static_cast<char>(character)));
    return character;
  }

 private:
  void Take(const std::string& text) {
    const bool was_found = text_.find(wanted_) != std::string::npos;
    text_ += text;
    if (!was_found && text_.find(wanted_) != std::string::npos) found_.set_value();
  }

  std::string wanted_;
  std::string text_;  // Written by the one thread that draws.
  std::promise<void> found_;
  std::streambuf* replaced_ = nullptr;
};

TEST(ProgressBarTest, ShowsThatOneLongItemGoesOn) {
  for (const bool on_terminal : {true, false}) {
    const Terminal terminal{.colours = false, .progress = on_terminal, .width = 0};
    Written written(on_terminal ? "0 of 1" : "touchstone: 0 of 1 after");
    ProgressBar bar(terminal, false);
    bar.Show(0, 1);
    written.Wait();
  }
}

}  // namespace
}  // namespace touchstone
