#include "core/parallel/partition.hpp"

#include <mpi.h>
#include <zoltan.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/errors.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// The part of all points that this rank shows to Zoltan.
template <int Dim>
struct Slice {
  std::span<const Vec<Dim>> x;
  std::span<const Real> weight;
  std::vector<std::size_t> shown;
};

template <int Dim>
int count_points(void* data, int* error) {
  *error = ZOLTAN_OK;
  return static_cast<int>(static_cast<const Slice<Dim>*>(data)->shown.size());
}

template <int Dim>
void list_points(void* data, int, int, ZOLTAN_ID_PTR ids, ZOLTAN_ID_PTR, int, float* weights,
                 int* error) {
  const auto& slice = *static_cast<const Slice<Dim>*>(data);
  for (std::size_t k = 0; k < slice.shown.size(); ++k) {
    ids[k] = static_cast<ZOLTAN_ID_TYPE>(slice.shown[k]);
    weights[k] = static_cast<float>(slice.weight[slice.shown[k]]);
  }
  *error = ZOLTAN_OK;
}

template <int Dim>
int count_axes(void*, int* error) {
  *error = ZOLTAN_OK;
  return Dim;
}

template <int Dim>
void place_points(void* data, int, int, int n, ZOLTAN_ID_PTR ids, ZOLTAN_ID_PTR, int, double* out,
                  int* error) {
  const auto& slice = *static_cast<const Slice<Dim>*>(data);
  for (int k = 0; k < n; ++k) {
    for (int c = 0; c < Dim; ++c) out[Dim * k + c] = slice.x[ids[k]][c];
  }
  *error = ZOLTAN_OK;
}

struct Destroy {
  void operator()(Zoltan_Struct* zoltan) const { Zoltan_Destroy(&zoltan); }
};

/// Zoltan needs MPI even where one process partitions for many; the session ends it.
void start_mpi() {
  int started = 0;
  MPI_Initialized(&started);
  if (!started) MPI_Init(nullptr, nullptr);
}

void require(int status, const char* what) {
  if (status != ZOLTAN_OK && status != ZOLTAN_WARN) {
    throw MachineError(std::string("Zoltan: ") + what + " failed");
  }
}

/// In whose region of space a point lies.
template <int Dim>
int part_around(Zoltan_Struct* zoltan, Vec<Dim> x) {
  int process = 0, part = 0;
  require(Zoltan_LB_Point_PP_Assign(zoltan, x.data(), &process, &part), "place of a point");
  return part;
}
}  // namespace

template <int Dim>
Partition make_partition(const Communicator& ranks, std::span<const Vec<Dim>> x,
                         std::span<const Real> weight, int parts) {
  Partition partition;
  partition.owner.assign(x.size(), 0);
  if (parts == 0) parts = ranks.size();
  const auto n_weighed = std::count_if(weight.begin(), weight.end(), [](Real w) { return w > 0; });
  parts = static_cast<int>(std::min<std::ptrdiff_t>(parts, n_weighed));  // others have nothing
  if (parts <= 1) return partition;
  start_mpi();
  float version = 0;
  require(Zoltan_Initialize(0, nullptr, &version), "start");
  const std::unique_ptr<Zoltan_Struct, Destroy> zoltan(Zoltan_Create(MPI_COMM_WORLD));
  if (!zoltan) throw MachineError("Zoltan: no memory");
  const auto n = slot_of(ranks.size());
  const auto r = slot_of(ranks.rank());
  const std::size_t first = x.size() * r / n, last = x.size() * (r + 1) / n;
  Slice<Dim> slice{x, weight, {}};
  for (std::size_t i = first; i < last; ++i) {
    if (weight[i] > 0) slice.shown.push_back(i);
  }
  const std::string n_parts = std::to_string(parts);
  for (const auto& [key, value] : {std::pair("DEBUG_LEVEL", "0"),
                                   {"LB_METHOD", "RCB"},
                                   {"NUM_GLOBAL_PARTS", n_parts.c_str()},
                                   {"NUM_GID_ENTRIES", "1"},
                                   {"NUM_LID_ENTRIES", "0"},
                                   {"OBJ_WEIGHT_DIM", "1"},
                                   {"KEEP_CUTS", "1"},
                                   {"RETURN_LISTS", "PARTS"},
                                   {"IMBALANCE_TOL", "1.01"}}) {
    require(Zoltan_Set_Param(zoltan.get(), key, value), key);
  }
  Zoltan_Set_Num_Obj_Fn(zoltan.get(), count_points<Dim>, &slice);
  Zoltan_Set_Obj_List_Fn(zoltan.get(), list_points<Dim>, &slice);
  Zoltan_Set_Num_Geom_Fn(zoltan.get(), count_axes<Dim>, &slice);
  Zoltan_Set_Geom_Multi_Fn(zoltan.get(), place_points<Dim>, &slice);
  int changes = 0, n_gid = 0, n_lid = 0, n_import = 0, n_export = 0;
  ZOLTAN_ID_PTR import_gid = nullptr, import_lid = nullptr, export_gid = nullptr,
                export_lid = nullptr;
  int *import_rank = nullptr, *import_part = nullptr, *export_rank = nullptr,
      *export_part = nullptr;
  require(Zoltan_LB_Partition(zoltan.get(), &changes, &n_gid, &n_lid, &n_import, &import_gid,
                              &import_lid, &import_rank, &import_part, &n_export, &export_gid,
                              &export_lid, &export_rank, &export_part),
          "recursive bisection");
  std::vector<std::int32_t> part(last - first, ranks.rank());
  for (int k = 0; k < n_export; ++k) part[export_gid[k] - first] = export_part[k];
  for (std::size_t i = first; i < last; ++i) {
    if (!(weight[i] > 0)) part[i - first] = part_around<Dim>(zoltan.get(), x[i]);
  }
  Zoltan_LB_Free_Part(&import_gid, &import_lid, &import_rank, &import_part);
  Zoltan_LB_Free_Part(&export_gid, &export_lid, &export_rank, &export_part);
  std::size_t at = 0;
  for (const auto& bytes : ranks.all_gather((Packer() << part).take())) {
    std::vector<std::int32_t> one;
    Unpacker(bytes) >> one;
    for (const std::int32_t owner : one) partition.owner[at++] = owner;
  }
  return partition;
}

template Partition make_partition<2>(const Communicator&, std::span<const Vec<2>>,
                                     std::span<const Real>, int);
template Partition make_partition<3>(const Communicator&, std::span<const Vec<3>>,
                                     std::span<const Real>, int);

}  // namespace brunt
