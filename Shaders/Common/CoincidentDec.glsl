uniform float cOffset; // VTK's offset of coincident topology, in 1/65000 of the depth range
