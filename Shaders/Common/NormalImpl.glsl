  normalVCVSOutput = mesoHit.NormalVC;
