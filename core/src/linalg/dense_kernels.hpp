// SPDX-License-Identifier: GPL-3.0-or-later
// dense_kernels.cpp compiles Eigen's products of dense matrices of doubles, with the optimisation of
// core. Each other source would make its own, which takes a tenth of its time. Only
// cmake/precompiled.hpp includes this file; without it everything compiles as well, and more slowly.
#pragma once

#include <Eigen/Dense>

/// Lists the instantiations. `kind` is empty for a definition, and extern for a declaration.
#define MICROSLIP_DENSE_KERNELS(kind)                                                             \
  namespace Eigen {                                                                               \
  namespace internal {                                                                            \
  kind template struct gebp_kernel<double, double, Index,                                         \
                                   blas_data_mapper<double, Index, ColMajor, Unaligned, 1>, 4, 4, \
                                   false, false>;                                                 \
  kind template struct general_matrix_matrix_product<Index, double, ColMajor, false, double,      \
                                                     ColMajor, false, ColMajor, 1>;               \
  kind template struct general_matrix_matrix_product<Index, double, RowMajor, false, double,      \
                                                     ColMajor, false, ColMajor, 1>;               \
  kind template struct general_matrix_matrix_product<Index, double, ColMajor, false, double,      \
                                                     RowMajor, false, ColMajor, 1>;               \
  kind template struct general_matrix_vector_product<                                             \
      Index, double, const_blas_data_mapper<double, Index, ColMajor>, ColMajor, false, double,    \
      const_blas_data_mapper<double, Index, RowMajor>, false, 0>;                                 \
  kind template struct general_matrix_vector_product<                                             \
      Index, double, const_blas_data_mapper<double, Index, ColMajor>, ColMajor, false, double,    \
      const_blas_data_mapper<double, Index, ColMajor>, false, 0>;                                 \
  kind template struct general_matrix_vector_product<                                             \
      Index, double, const_blas_data_mapper<double, Index, RowMajor>, RowMajor, false, double,    \
      const_blas_data_mapper<double, Index, ColMajor>, false, 0>;                                 \
  kind template struct general_matrix_vector_product<                                             \
      Index, double, const_blas_data_mapper<double, Index, RowMajor>, RowMajor, false, double,    \
      const_blas_data_mapper<double, Index, RowMajor>, false, 1>;                                 \
  }                                                                                               \
  }

MICROSLIP_DENSE_KERNELS(extern)
