#pragma once

#include <string>

namespace pinball {

/// Whether the data that the header of a netCDF file of the classic formats (CDF-1, 2 and 5) speaks of lies within the
/// file: what is missing libnetcdf reads as zeros. Throws InputError "PATH: ..." where it does not, or the header is
/// damaged; says nothing of files of other formats.
void check_netcdf_header(const std::string& path);

}  // namespace pinball
