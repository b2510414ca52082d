// Ctrl+C and its like as a request to end: what a long command has found is kept.
//
// While an EndRequest lives, the first SIGINT, SIGTERM or SIGHUP is noted and nothing else; another one, seconds later,
// ends the process as it would have without. One request often comes twice: timeout(1) sends it to its child and to the
// group, a script passes on what its child has got, too. Not its job: what is kept.
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
