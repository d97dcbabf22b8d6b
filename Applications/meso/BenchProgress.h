#ifndef BenchProgress_h
#define BenchProgress_h

#include <chrono>
#include <string>

/// A line on the terminal that says what is done, how much of the whole, and the time left; nothing
/// where standard error is no terminal.
class BenchProgress
{
public:
  /// Steps count by their cost, roughly: 1 is one arm rendered and judged.
  void SetTotal(double steps) { this->Total = steps; }
  /// What begins now, and what it counts.
  void Begin(const std::string& text, double steps);
  /// Steps that need not be done.
  void Skip(double steps);
  /// Ends the line.
  void End();

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  double Total = 1.;
  double Done = 0.;    ///< before the current step
  double Current = 0.; ///< steps that the current one counts
};

#endif
