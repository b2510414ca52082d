// Ctrl+C and its like as a request to end: what a long command has found is kept.
//
// While an EndRequest lives, the first SIGINT, SIGTERM or SIGHUP is noted and nothing else; a second one ends the
// process as it would have without. Not its job: what is kept.
#pragma once

namespace plcxx::driver {

class EndRequest {
 public:
  EndRequest();
  EndRequest(const EndRequest&) = delete;
  EndRequest& operator=(const EndRequest&) = delete;
  ~EndRequest();

  /// By a signal in the time of any of them.
  static bool IsMade();
  /// What follows is short, and not to be cut off: further signals are ignored.
  void IgnoreFurther();
};

}  // namespace plcxx::driver
