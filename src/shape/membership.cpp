#include "shape/membership.h"

namespace partonomy {

double Trapezoid::operator()(double x) const {
    if (!(x >= a1 && x <= a4)) return 0;
    if (x < a2) return (x - a1) / (a2 - a1);
    if (x > a3) return (a4 - x) / (a4 - a3);
    return 1;
}

}  // namespace partonomy
