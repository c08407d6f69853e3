// The worker of the page that maps one region to another.

import { serveJobs } from "../common/serve.js";
import { RegionsPipeline } from "./pipeline.js";

serveJobs(new RegionsPipeline());
