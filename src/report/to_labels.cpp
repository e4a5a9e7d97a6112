#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {

std::string to_labels(const Annotation& annotation) {
    std::string text;
    for (const std::string& label : annotation.labels) {
        text += label.empty() ? "-" : one_line(label);
        text += '\n';
    }
    return text;
}

}  // namespace partonomy
