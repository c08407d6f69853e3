// The worker of the region's page.

import { serveJobs } from "../common/serve.js";
import { RegionPipeline } from "./pipeline.js";

serveJobs(new RegionPipeline());
