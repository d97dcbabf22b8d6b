#include "BenchProgress.h"

#include <cmath>
#include <iostream>
#include <unistd.h>

void BenchProgress::Begin(const std::string& text, double steps)
{
  this->Done += this->Current;
  this->Current = steps;
  if (!isatty(STDERR_FILENO))
  {
    return;
  }
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  std::string left;
  if (this->Done > 0.)
  {
    const double rest = seconds * (this->Total - this->Done) / this->Done;
    left = rest < 90. ? std::to_string(std::lround(rest)) + " s"
                      : std::to_string(std::lround(rest / 60.)) + " min";
    left = ", about " + left + " left";
  }
  std::cerr << "\r\033[K" << std::lround(100. * this->Done / this->Total) << " %" << left << ": "
            << text << std::flush;
}

void BenchProgress::Skip(double steps)
{
  // So that the time left is told from the steps that took time.
  this->Total -= steps;
}

void BenchProgress::End()
{
  if (isatty(STDERR_FILENO))
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}
