// The nets of a drawing: what is connected, what is wrong with it, in which order it is evaluated (specification 3.6,
// rules 4 to 8).
#include <algorithm>
#include <functional>
#include <numeric>

#include "transpiler/dialects/host50/parser/drawing.h"

namespace plcxx::host50 {
namespace {

/// Sets of nodes that are joined.
class UnionFind {
 public:
  uint32_t Add() {
    parents_.push_back(static_cast<uint32_t>(parents_.size()));
    return parents_.back();
  }
  uint32_t Find(uint32_t node) {
    while (parents_[node] != node) {
      parents_[node] = parents_[parents_[node]];
      node = parents_[node];
    }
    return node;
  }
  /// The smaller root stays: a net is known by its first node.
  void Join(uint32_t a, uint32_t b) {
    a = Find(a), b = Find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }
  uint32_t size() const { return static_cast<uint32_t>(parents_.size()); }

 private:
  std::vector<uint32_t> parents_;
};

struct CellNode {
  uint32_t node = 0;   // of an element: its left end
  uint32_t right = 0;  // of an element: its right end; else the same node
  bool left_side = false, right_side = false, up = false, down = false;  // connections
  uint32_t connections() const { return left_side + right_side + up + down; }
};

/// By the root of its nodes.
struct Net {
  bool has_rail = false;
  bool only_rail = true;
  bool reported = false;
  std::vector<uint32_t> sources;    // elements whose right ends are on it, in row-column order
  std::vector<uint32_t> consumers;  // elements whose left ends are on it
  source::Range first;              // its first cell that is no rail
};

class Connections {
 public:
  Connections(Drawing& drawing, std::span<ElementMeaning> meanings, diag::Engine& diagnostics)
      : drawing_(drawing), meanings_(meanings), diagnostics_(diagnostics), ends_(meanings.size()) {}

  std::optional<Wiring> Run() {
    AddNodes();
    JoinRows();
    JoinColumns();
    CollectNets();
    CheckCoils();
    CheckSources();
    CheckDangling();
    CheckBypassed();
    CheckCycles();
    if (drawing_.faulty) return std::nullopt;
    return Order();
  }

 private:
  struct ElementEnds {
    uint32_t row = 0, cell = 0;
  };

  template <class Visit>
  void ForEachCell(Visit visit) {
    for (uint32_t r = 0; r < drawing_.rows.size(); ++r) {
      const std::vector<DrawnCell>& cells = drawing_.rows[r].cells;
      for (uint32_t c = 0; c < cells.size(); ++c) visit(cells[c], nodes_[r][c]);
    }
  }

  CellNode& NodeOf(uint32_t element) { return nodes_[ends_[element].row][ends_[element].cell]; }
  Net& LeftNet(uint32_t element) { return nets_[sets_.Find(NodeOf(element).node)]; }
  Net& RightNet(uint32_t element) { return nets_[sets_.Find(NodeOf(element).right)]; }
  source::Range RangeOf(uint32_t element) const { return drawing_.elements[element].range; }

  bool Is(uint32_t element, RungEffect effect) const {
    return meanings_[element].op && Info(*meanings_[element].op).effect == effect;
  }
  bool IsCoil(uint32_t element) const { return drawing_.elements[element].bracket == '('; }
  bool IsContact(uint32_t element) const { return drawing_.elements[element].bracket == '['; }
  uint32_t count() const { return static_cast<uint32_t>(meanings_.size()); }

  template <class... Args>
  void FaultOfElement(uint32_t element, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    drawing_.faulty = true;
    if (!std::exchange(meanings_[element].faulty, true)) diagnostics_.Report(RangeOf(element), message, args...);
  }
  template <class... Args>
  void FaultOfNet(Net& net, source::Range range, const diag::Message<Args...>& message,
                  std::type_identity_t<Args>... args) {
    drawing_.faulty = true;
    if (!std::exchange(net.reported, true)) diagnostics_.Report(range, message, args...);
  }

  void AddNodes();
  void JoinRows();
  void JoinColumns();
  void CollectNets();
  bool IsRightRail(uint32_t element) const;
  void CheckCoils();
  void CheckSources();
  void CheckDangling();
  void CheckBypassed();
  void CheckCycles();
  Wiring Order();

  Drawing& drawing_;
  std::span<ElementMeaning> meanings_;
  diag::Engine& diagnostics_;
  std::vector<std::vector<CellNode>> nodes_;  // by row and cell
  std::vector<ElementEnds> ends_;             // by element
  UnionFind sets_;
  std::vector<Net> nets_;    // by node; used at roots
  bool right_rail_ = false;  // reported
};

void Connections::AddNodes() {
  std::optional<uint32_t> rail;
  for (uint32_t r = 0; r < drawing_.rows.size(); ++r) {
    std::vector<CellNode>& row = nodes_.emplace_back();
    for (const DrawnCell& cell : drawing_.rows[r].cells) {
      CellNode node{.node = sets_.Add()};
      node.right = cell.kind == CellKind::kElement ? sets_.Add() : node.node;
      if (cell.kind == CellKind::kElement) ends_[cell.element] = {r, static_cast<uint32_t>(row.size())};
      if (cell.kind == CellKind::kRail) {
        if (rail) sets_.Join(*rail, node.node);
        rail = node.node;
      }
      row.push_back(node);
    }
  }
}

/// Rule 4: neighbours of a row.
void Connections::JoinRows() {
  for (uint32_t r = 0; r < drawing_.rows.size(); ++r) {
    const std::vector<DrawnCell>& cells = drawing_.rows[r].cells;
    for (uint32_t c = 1; c < cells.size(); ++c) {
      const DrawnCell &left = cells[c - 1], &right = cells[c];
      if (left.end != right.begin || left.kind == CellKind::kLink || right.kind == CellKind::kLink) continue;
      sets_.Join(nodes_[r][c - 1].right, nodes_[r][c].node);
      nodes_[r][c - 1].right_side = nodes_[r][c].left_side = true;
    }
  }
}

/// Rule 4: '+' and '|' above each other.
void Connections::JoinColumns() {
  const auto joins = [](const DrawnCell& cell) {
    return cell.kind == CellKind::kJunction || cell.kind == CellKind::kLink;
  };
  for (uint32_t r = 1; r < drawing_.rows.size(); ++r) {
    const std::vector<DrawnCell>&above = drawing_.rows[r - 1].cells, &below = drawing_.rows[r].cells;
    for (uint32_t a = 0, b = 0; a < above.size() && b < below.size();) {
      if (above[a].begin == below[b].begin && joins(above[a]) && joins(below[b])) {
        sets_.Join(nodes_[r - 1][a].node, nodes_[r][b].node);
        nodes_[r - 1][a].down = nodes_[r][b].up = true;
      }
      above[a].begin < below[b].begin ? ++a : ++b;
    }
  }
}

void Connections::CollectNets() {
  nets_.resize(sets_.size());
  ForEachCell([&](const DrawnCell& cell, const CellNode& node) {
    if (cell.kind == CellKind::kElement) {
      if (node.left_side) nets_[sets_.Find(node.node)].consumers.push_back(cell.element);
      if (node.right_side) nets_[sets_.Find(node.right)].sources.push_back(cell.element);
      return;
    }
    Net& net = nets_[sets_.Find(node.node)];
    if (cell.kind == CellKind::kRail) {
      net.has_rail = true;
    } else if (std::exchange(net.only_rail, false)) {
      net.first = cell.range;
    }
  });
}

/// The coil is the last element of its row, and after it are wires and, at the end, a '|'.
bool Connections::IsRightRail(uint32_t element) const {
  const std::vector<DrawnCell>& cells = drawing_.rows[ends_[element].row].cells;
  const auto behind = std::span(cells).subspan(ends_[element].cell + 1);
  return !behind.empty() && behind.back().kind == CellKind::kLink &&
         std::ranges::all_of(behind.first(behind.size() - 1),
                             [](const DrawnCell& cell) { return cell.kind == CellKind::kWire; });
}

/// E608; the net right of a coil is not looked at any more.
void Connections::CheckCoils() {
  for (uint32_t element = 0; element < count(); ++element) {
    if (!IsCoil(element) || !NodeOf(element).right_side) continue;
    RightNet(element).reported = true;
    if (!IsRightRail(element)) {
      FaultOfElement(element, diag::Host50LadderBehindCoil);
      continue;
    }
    if (std::exchange(right_rail_, true)) meanings_[element].faulty = true;  // one fault for all its rows
    FaultOfElement(element, diag::Host50LadderRightRail);
    nets_[sets_.Find(nodes_[ends_[element].row].back().node)].reported = true;
  }
}

/// E603.
void Connections::CheckSources() {
  ForEachCell([&](const DrawnCell& cell, const CellNode& node) {
    if (cell.kind == CellKind::kElement) {
      if (!node.left_side) FaultOfElement(cell.element, diag::Host50LadderNoSource, "element");
      return;
    }
    Net& net = nets_[sets_.Find(node.node)];
    if (cell.kind == CellKind::kWire && !node.left_side)
      FaultOfNet(net, cell.range, diag::Host50LadderNoSource, "wire");
    if (!net.has_rail && net.sources.empty()) FaultOfNet(net, net.first, diag::Host50LadderNoSource, "wire");
  });
}

/// E604.
void Connections::CheckDangling() {
  ForEachCell([&](const DrawnCell& cell, const CellNode& node) {
    if (cell.kind == CellKind::kElement) {
      const bool needs_more = IsContact(cell.element) || Is(cell.element, RungEffect::kCompare);
      if (needs_more && !node.right_side) FaultOfElement(cell.element, diag::Host50LadderDangling, "element");
      return;
    }
    Net& net = nets_[sets_.Find(node.node)];
    if (cell.kind == CellKind::kWire && !node.right_side)
      FaultOfNet(net, cell.range, diag::Host50LadderDangling, "wire");
    if (cell.kind == CellKind::kLink && !(node.up && node.down)) {
      FaultOfNet(net, cell.range, diag::Host50LadderDangling, "link '|'");
    }
    if (cell.kind == CellKind::kJunction && node.connections() < 2) {
      FaultOfNet(net, cell.range, diag::Host50LadderDangling, "junction '+'");
    }
    if (!net.only_rail && net.consumers.empty()) FaultOfNet(net, net.first, diag::Host50LadderDangling, "wire");
  });
}

/// E605: a wire around an element.
void Connections::CheckBypassed() {
  for (uint32_t element = 0; element < count(); ++element) {
    const CellNode& node = NodeOf(element);
    if (node.left_side && node.right_side && sets_.Find(node.node) == sets_.Find(node.right)) {
      FaultOfElement(element, diag::Host50LadderBypassed);
    }
  }
}

/// E605: elements in a circle, at the first one of each. Nets that reach each other are a circle.
void Connections::CheckCycles() {
  if (count() > kMostRows * kMostCells) return;  // refused already; the walk is as deep as there are elements
  std::vector<uint32_t> index(nets_.size()), low(nets_.size()), component(nets_.size());
  std::vector<uint32_t> stack;
  uint32_t next_index = 0, components = 0;
  const std::function<void(uint32_t)> visit = [&](uint32_t net) {
    index[net] = low[net] = ++next_index;
    stack.push_back(net);
    for (const uint32_t element : nets_[net].consumers) {
      if (!NodeOf(element).right_side) continue;
      const uint32_t target = sets_.Find(NodeOf(element).right);
      if (index[target] == 0) {
        visit(target);
        low[net] = std::min(low[net], low[target]);
      } else if (component[target] == 0) {
        low[net] = std::min(low[net], index[target]);
      }
    }
    if (low[net] != index[net]) return;
    ++components;
    for (bool more = true; more;) {
      const uint32_t member = stack.back();
      stack.pop_back();
      component[member] = components;
      more = member != net;
    }
  };
  std::vector<bool> reported(nets_.size() + 1);
  for (uint32_t element = 0; element < count(); ++element) {
    const CellNode& node = NodeOf(element);
    if (!node.left_side || !node.right_side) continue;
    const uint32_t left = sets_.Find(node.node), right = sets_.Find(node.right);
    if (index[left] == 0) visit(left);
    if (left == right || component[left] != component[right] || reported[component[left]]) continue;
    reported[component[left]] = true;
    FaultOfElement(element, diag::Host50LadderCycle);
  }
}

/// Rule 8: actions by row and column, each after what its input needs.
Wiring Connections::Order() {
  Wiring wiring;
  wiring.inputs.resize(count());
  std::vector<bool> done(count());
  const std::function<void(uint32_t)> evaluate = [&](uint32_t element) {
    if (done[element]) return;
    done[element] = true;
    const Net& net = LeftNet(element);
    wiring.inputs[element] = {.from_rail = net.has_rail, .sources = net.sources};
    for (const uint32_t source : net.sources) evaluate(source);
    wiring.order.push_back(element);
  };
  for (uint32_t element = 0; element < count(); ++element) {
    if (!IsContact(element)) evaluate(element);
  }
  return wiring;
}

}  // namespace

std::optional<Wiring> Connect(Drawing& drawing, std::span<ElementMeaning> meanings, diag::Engine& diagnostics) {
  if (!drawing.readable) return std::nullopt;
  return Connections(drawing, meanings, diagnostics).Run();
}

}  // namespace plcxx::host50
